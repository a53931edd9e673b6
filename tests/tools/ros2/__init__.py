"""The node `armui-ros2` in a real ROS 2, before a simulated arm, with a stranger's node."""

import sys
from pathlib import Path

# armui-client need not be installed where armui is
sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "resources/clients/armui_client"))
