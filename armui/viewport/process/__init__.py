"""The process that draws the 3D picture: VTK, pyvista, trimesh and yourdfpy live only here.

Nothing of this package is imported by the program's other process; see
`armui.viewport.process_link`.
"""
