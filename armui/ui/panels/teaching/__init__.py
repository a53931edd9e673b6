"""示教: drag teaching, and the way out of it."""
