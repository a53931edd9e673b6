"""Prints the joints of the arm five times a second, for three seconds. Nothing moves."""

import itertools

import armui_client


def main() -> None:
    """Read and print."""
    with armui_client.connect("read.py") as arm:
        print(arm.hello["arm"]["model"], "simulated" if arm.hello["arm"]["simulated"] else "real")
        for state in itertools.islice(arm.subscribe(rate_hz=5), 15):
            angles = ", ".join(f"{each:7.2f}" for each in state.joints_deg.get())
            print(f"{angles} °, {state.joints_deg.age_s} s old")


if __name__ == "__main__":
    main()
