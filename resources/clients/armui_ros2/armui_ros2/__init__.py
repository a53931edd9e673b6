"""A ROS 2 node for an AgileX PiPER arm, which it reads and moves through armui.

``node`` is the only module that knows ROS. ``figures`` has names and units, ``trajectory`` checks
and interpolates, ``link`` holds the connection to armui, ``follower`` the lease and the motion.
"""

__version__ = "0.1.0"
