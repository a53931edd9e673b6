"""The trajectory library, its editor, its run controls and the preview."""
