"""Forward and inverse kinematics, Jacobian, tool paths and their pace; numbers only.

One closed form (`forward`, `inverse`, `jacobians`, `singularity`) for one pose and for arrays of
them; `arm_kinematics` wraps it for single poses.
"""
