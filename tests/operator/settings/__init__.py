"""An operator at 关节设置, 配速设置, 碰撞等级: bytes at the arm, what it then holds, words."""
