"""Robot descriptions written for tests."""

from pathlib import Path

ARM = """<robot name="r">
{links}
{joints}
{extra}
</robot>"""


def link(name: str, visual: str = "") -> str:
    return f'<link name="{name}">{visual}</link>'


def mesh(filename: str, scale: str = "1 1 1") -> str:
    return f'<visual><geometry><mesh filename="{filename}" scale="{scale}"/></geometry></visual>'


def joint(name: str, parent: str, child: str, kind: str = "revolute", inside: str = "") -> str:
    return (
        f'<joint name="{name}" type="{kind}"><origin xyz="0 0 0.1"/><parent link="{parent}"/>'
        f'<child link="{child}"/><axis xyz="0 1 0"/>{inside}</joint>'
    )


def write_arm(
    folder: Path, *, hinges: int = 6, visual: str = "", extra: str = "", name: str = "arm.urdf"
) -> Path:
    """An arm of so many hinges in a row, every link with the same picture."""
    links = "".join(link(f"l{number}", visual) for number in range(hinges + 1))
    joints = "".join(
        joint(f"j{number}", f"l{number - 1}", f"l{number}") for number in range(1, hinges + 1)
    )
    path = folder / name
    path.write_text(ARM.format(links=links, joints=joints, extra=extra), encoding="utf-8")
    return path
