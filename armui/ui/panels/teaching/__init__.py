"""示教: drag teaching, and the steps that leave it safely."""
