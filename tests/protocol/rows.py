"""Frames worked out by hand from the protocol's tables, one row a message.

A row is (identifier, payload, message, signals); signals that are 0 are left out. A message that
comes periodically, and not with the controller's or the drivers' feedback, says how often. Numbers
are big-endian and two's complement; the comments show how physical values become bytes.
"""

from __future__ import annotations

from typing import NamedTuple

from armui.protocol.generation import Generation


class Row(NamedTuple):
    arbitration_id: int
    payload: str
    name: str
    signals: dict[str, float]
    cycle_ms: int | None = None

    def __str__(self) -> str:
        return self.name


# fmt: off
BOTH = [
    Row(0x121, "01 03 FF 10 20 30 00 07", "LightControl",
        {"Enable": 1, "Joint": 3, "Lamp": 255, "Red": 16, "Green": 32, "Blue": 48, "Counter": 7}),
    # 56.128 mm = 56128 = 0xDB40; -0.001 mm = -1
    Row(0x152, "00 00 DB 40 FF FF FF FF", "CartesianTarget1", {"X": 56.128, "Y": -0.001}),
    # 213.266 mm = 213266 = 0x34112; -180° = -180000 = -0x2BF20 = 0xFFFD40E0
    Row(0x153, "00 03 41 12 FF FD 40 E0", "CartesianTarget2", {"Z": 213.266, "RX": -180.0}),
    # 85° = 85000 = 0x14C08
    Row(0x154, "00 01 4C 08 00 00 00 01", "CartesianTarget3", {"RY": 85.0, "RZ": 0.001}),
    # 150° = 150000 = 0x249F0; its negative is 0xFFFDB610
    Row(0x155, "00 02 49 F0 FF FD B6 10", "JointTarget12", {"J1": 150.0, "J2": -150.0}),
    # -170° = -170000 = -0x29810 = 0xFFFD67F0; 100° = 100000 = 0x186A0
    Row(0x156, "FF FD 67 F0 00 01 86 A0", "JointTarget34", {"J3": -170.0, "J4": 100.0}),
    # the ends of int32
    Row(0x157, "7F FF FF FF 80 00 00 00", "JointTarget56", {"J5": 2147483.647, "J6": -2147483.648}),
    # -56.128 mm = -0xDB40 = 0xFFFF24C0; 600 mm = 600000 = 0x927C0
    Row(0x2A2, "FF FF 24 C0 00 09 27 C0", "EndPose1", {"X": -56.128, "Y": 600.0}),
    # 213.266 mm as above; 90° = 90000 = 0x15F90
    Row(0x2A3, "00 03 41 12 00 01 5F 90", "EndPose2", {"Z": 213.266, "RX": 90.0}),
    # -45.5° = -45500 = -0xB1BC = 0xFFFF4E44
    Row(0x2A4, "00 01 4C 08 FF FF 4E 44", "EndPose3", {"RY": 85.0, "RZ": -45.5}),
    # -1° = -1000 = -0x3E8 = 0xFFFFFC18
    Row(0x2A5, "00 01 5F 90 FF FF FC 18", "JointFeedback12", {"J1": 90.0, "J2": -1.0}),
    # 0.5° = 500 = 0x1F4
    Row(0x2A6, "FF FD 67 F0 00 00 01 F4", "JointFeedback34", {"J3": -170.0, "J4": 0.5}),
    # -70° = -70000 = -0x11170 = 0xFFFEEE90; 120° = 120000 = 0x1D4C0
    Row(0x2A7, "FF FE EE 90 00 01 D4 C0", "JointFeedback56", {"J5": -70.0, "J6": 120.0}),
    Row(0x471, "07 02 00 00 00 00 00 00", "MotorEnable", {"Joint": 7, "Action": 2}),
    Row(0x472, "06 01 00 00 00 00 00 00", "LimitQuery", {"Joint": 6, "Query": 1}),
    # 1 m/s = 1000 = 0x3E8; 0.5 rad/s = 0x1F4; 10 m/s² = 10000 = 0x2710; 65.535 rad/s² = 0xFFFF
    Row(0x478, "03 E8 01 F4 27 10 FF FF", "EndLimitFeedback",
        {"MaxLinearSpeed": 1.0, "MaxAngularSpeed": 0.5,
         "MaxLinearAcceleration": 10.0, "MaxAngularAcceleration": 65.535}),
    Row(0x47A, "00 01 02 03 04 08 00 00", "CollisionSetting",
        {"J2": 1, "J3": 2, "J4": 3, "J5": 4, "J6": 8}),
    Row(0x47B, "08 07 06 05 04 00 00 00", "CollisionFeedback",
        {"J1": 8, "J2": 7, "J3": 6, "J4": 5, "J5": 4}),
    # 100 = 0x64, 200 = 0xC8, 300 = 0x12C, 400 = 0x190
    Row(0x481, "00 64 00 C8 01 2C 01 90", "EndMotion1",
        {"LinearSpeed": 0.1, "AngularSpeed": 0.2,
         "LinearAcceleration": 0.3, "AngularAcceleration": 0.4}),
    Row(0x482, "00 01 00 02 00 03 00 04", "EndMotion2",
        {"LinearSpeed": 0.001, "AngularSpeed": 0.002,
         "LinearAcceleration": 0.003, "AngularAcceleration": 0.004}),
    # 1000 = 0x3E8, 2000 = 0x7D0, 3000 = 0xBB8, 4000 = 0xFA0
    Row(0x483, "03 E8 07 D0 0B B8 0F A0", "EndMotion3",
        {"LinearSpeed": 1.0, "AngularSpeed": 2.0,
         "LinearAcceleration": 3.0, "AngularAcceleration": 4.0}),
    Row(0x484, "FF FF 00 00 00 00 00 00", "EndMotion4", {"LinearSpeed": 65.535}),
    Row(0x485, "00 00 FF FF 00 00 00 00", "EndMotion5", {"AngularSpeed": 65.535}),
    # either side of the sign bit: unsigned
    Row(0x486, "01 00 00 FF 7F FF 80 00", "EndMotion6",
        {"LinearSpeed": 0.256, "AngularSpeed": 0.255,
         "LinearAcceleration": 32.767, "AngularAcceleration": 32.768}),
]

GENERATION_1 = [
    Row(0x150, "01 05 06 00 00 00 00 00", "MotionCommand",
        {"EmergencyStop": 1, "TrajectoryCommand": 5, "TeachingCommand": 6}),
    # 50 % = 0x32
    Row(0x151, "01 01 32 00 00 00 00 00", "ModeControl",
        {"ControlMode": 1, "MoveMode": 1, "SpeedPercent": 50}),
    Row(0x158, "03", "ArcPoint", {"Point": 3}),
    # 70° = 70000 = 0x11170; 1.5 rad/s = 1500 = 0x5DC; bits 0 and 1
    Row(0x159, "00 01 11 70 05 DC 03 00", "GripperCommand",
        {"Angle": 70.0, "Speed": 1.5, "Enable": 1, "ClearError": 1}),
    # -1500 rpm = -0x5DC = 0xFA24; 2.5 A = 25 = 0x19; 65536 pulses
    Row(0x251, "FA 24 00 19 00 01 00 00", "DriverFast1",
        {"Speed": -1500, "Current": 2.5, "Position": 65536}),
    # current is unsigned
    Row(0x252, "00 01 FF FF FF FF FF FF", "DriverFast2",
        {"Speed": 1, "Current": 6553.5, "Position": -1}),
    Row(0x253, "7F FF 00 00 7F FF FF FF", "DriverFast3", {"Speed": 32767, "Position": 2147483647}),
    Row(0x254, "80 00 00 01 80 00 00 00", "DriverFast4",
        {"Speed": -32768, "Current": 0.1, "Position": -2147483648}),
    # 300 = 0x12C; 10 A = 100 = 0x64; 1000 = 0x3E8
    Row(0x255, "01 2C 00 64 00 00 03 E8", "DriverFast5",
        {"Speed": 300, "Current": 10.0, "Position": 1000}),
    Row(0x256, "FF FF 00 02 FF FF FC 18", "DriverFast6",
        {"Speed": -1, "Current": 0.2, "Position": -1000}),
    # 24.0 V = 240 = 0xF0; 45 °C = 0x2D; 38 °C = 0x26; bits 0 and 6; 1.2 A = 12 = 0x0C
    Row(0x261, "00 F0 00 2D 26 41 00 0C", "DriverSlow1",
        {"Voltage": 24.0, "DriverTemperature": 45, "MotorTemperature": 38,
         "Undervoltage": 1, "Enabled": 1, "BusCurrent": 1.2}),
    # 23.9 V = 239 = 0xEF; -5 °C = 0xFFFB; -10 °C = 0xF6; bits 1, 6 and 7
    Row(0x262, "00 EF FF FB F6 C2 00 00", "DriverSlow2",
        {"Voltage": 23.9, "DriverTemperature": -5, "MotorTemperature": -10,
         "MotorOvertemperature": 1, "Enabled": 1, "Homed": 1}),
    Row(0x263, "00 00 00 00 00 04 00 00", "DriverSlow3", {"Overcurrent": 1}),
    Row(0x264, "00 00 00 00 00 08 00 00", "DriverSlow4", {"DriverOvertemperature": 1}),
    Row(0x265, "00 00 00 00 00 10 00 00", "DriverSlow5", {"SensorFault": 1}),
    # 6553.5 A = 0xFFFF: unsigned
    Row(0x266, "FF FF 00 00 00 20 FF FF", "DriverSlow6",
        {"Voltage": 6553.5, "DriverFault": 1, "BusCurrent": 6553.5}),
    # 100 % = 0x64; joints 1 and 6: bits 0 and 5
    Row(0x2A1, "06 0D 03 07 01 64 00 21", "ArmStatus",
        {"ControlMode": 6, "Status": 13, "MoveMode": 3, "TeachingState": 7, "MotionState": 1,
         "SpeedPercent": 100, "J1CommunicationFault": 1, "J6CommunicationFault": 1}),
    # -0.5° = -500 = -0x1F4 = 0xFFFFFE0C; speed is unsigned
    Row(0x2A8, "FF FF FE 0C FF FF 01 00", "GripperFeedback",
        {"Angle": -0.5, "Speed": 65.535, "Enabled": 1}),
    Row(0x422, "02", "BusSilence", {"Mode": 2}),
    Row(0x470, "FA 10 20 10", "LinkageSetting",
        {"Role": 0xFA, "FeedbackOffset": 0x10, "ControlOffset": 0x20, "TargetOffset": 0x10}),
    # 180° = 1800 = 0x708; -0.1° = -1; 300 rpm = 0x12C
    Row(0x473, "02 07 08 FF FF 01 2C 00", "LimitFeedback",
        {"Joint": 2, "MaxAngle": 180.0, "MinAngle": -0.1, "MaxSpeed": 300}),
    # 120° = 1200 = 0x4B0, its negative is 0xFB50; 3000 rpm = 0xBB8
    Row(0x474, "06 04 B0 FB 50 0B B8 00", "LimitSetting",
        {"Joint": 6, "MaxAngle": 120.0, "MinAngle": -120.0, "MaxSpeed": 3000}),
    # 500 rpm/s = 0x1F4
    Row(0x475, "07 AE AE 01 F4 AE 00 00", "JointSetting",
        {"Joint": 7, "SetZero": 0xAE, "AccelerationValid": 0xAE, "MaxAcceleration": 500,
         "ClearError": 0xAE}),
    Row(0x476, "75 01 00 00 00 00 00 00", "SettingResponse", {"Index": 0x75, "ZeroSet": 1}),
    Row(0x477, "02 01 01 AE 02 00 00 00", "ParameterCommand",
        {"Query": 2, "Reset": 1, "EndFeedback": 1, "LoadValid": 0xAE, "Load": 2}),
    # 0x7FFF is a number like any other here
    Row(0x479, "03 E8 07 D0 0B B8 7F FF", "EndLimitSetting",
        {"MaxLinearSpeed": 1.0, "MaxAngularSpeed": 2.0,
         "MaxLinearAcceleration": 3.0, "MaxAngularAcceleration": 32.767}),
    # 5000 rpm/s = 0x1388
    Row(0x47C, "05 13 88 00 00 00 00 00", "AccelerationFeedback",
        {"Joint": 5, "MaxAcceleration": 5000}),
]

GENERATION_2 = [
    # 0x0102 = 258; 0xABCD = 43981
    Row(0x150, "02 07 03 09 01 02 AB CD", "MotionCommand",
        {"EmergencyStop": 2, "TrajectoryCommand": 7, "TeachingCommand": 3, "TrajectoryPoint": 9,
         "NameIndex": 258, "Crc16": 43981}),
    Row(0x151, "07 06 64 AD FF 04 00 00", "ModeControl",
        {"ControlMode": 7, "MoveMode": 6, "SpeedPercent": 100, "MitMode": 0xAD, "DwellTime": 255,
         "Mounting": 4}),
    Row(0x158, "03 00 00 00 00 00 00 00", "ArcPoint", {"Point": 3}),
    # 70 mm = 70000 = 0x11170; 5 N·m = 5000 = 0x1388; bit 1; 0xAE sets zero
    Row(0x159, "00 01 11 70 13 88 02 AE", "GripperCommand",
        {"Opening": 70.0, "Torque": 5.0, "ClearError": 1, "SetZero": 0xAE}),
    # 45.5° = 45500 = 0xB1BC; 1 N·m = 0x3E8; bits 0 and 2
    Row(0x159, "00 00 B1 BC 03 E8 05 00", "GripperCommand",
        {"Angle": 45.5, "Torque": 1.0, "Enable": 1, "Measure": 1}),
    # nibbles: position 4, velocity 3, kp 3, kd 3, torque 3; raw 0 is the lower end of each
    Row(0x15A, "00 00 00 00 00 00 00 00", "MitControl1",
        {"Position": -12.5, "Velocity": -45.0, "Kd": -5.0, "Torque": -16.0}),
    # all ones is the upper end
    Row(0x15B, "FF FF FF FF FF FF FF FF", "MitControl2",
        {"Position": 12.5, "Velocity": 45.0, "Kp": 500.0, "Kd": 5.0, "Torque": 16.0}),
    # 8000 800 052 947 801: 32768·25/65535 - 12.5, 2048·90/4095 - 45, 82·500/4095,
    # 2375·10/4095 - 5, 2049·32/4095 - 16
    Row(0x15C, "80 00 80 00 52 94 78 01", "MitControl3",
        {"Position": 0.00019073777, "Velocity": 0.01098901099, "Kp": 10.01221001,
         "Kd": 0.7997557998, "Torque": 0.01172161172}),
    Row(0x15D, "FF FF 00 00 00 00 0F FF", "MitControl4",
        {"Position": 12.5, "Velocity": -45.0, "Kd": -5.0, "Torque": 16.0}),
    Row(0x15E, "00 00 FF F0 00 FF F0 00", "MitControl5",
        {"Position": -12.5, "Velocity": 45.0, "Kd": 5.0, "Torque": -16.0}),
    Row(0x15F, "00 00 00 0F FF 00 00 00", "MitControl6",
        {"Position": -12.5, "Velocity": -45.0, "Kp": 500.0, "Kd": -5.0, "Torque": -16.0}),
    # 77 writes; "po" = 70 6F = 28783; 0.5 rad = 28.648° = 28648 = 0x6FE8
    Row(0x181, "77 70 6F 00 00 6F E8", "CpvControl1",
        {"Action": 0x77, "Kind": 28783, "PositionTarget": 28.648}),
    # "sp" = 73 70 = 29552; -0.5 rad/s = -500 = 0xFFFFFE0C
    Row(0x182, "77 73 70 FF FF FE 0C", "CpvControl2",
        {"Action": 0x77, "Kind": 29552, "SpeedTarget": -0.5}),
    # 61 answers; "kp" = 6B 70 = 27504; 1.5 = 150 = 0x96
    Row(0x183, "61 6B 70 00 00 00 96", "CpvControl3",
        {"Action": 0x61, "Kind": 27504, "SpeedKp": 1.5}),
    # 72 reads; "ac" = 61 63 = 24931
    Row(0x184, "72 61 63 00 00 00 00", "CpvControl4", {"Action": 0x72, "Kind": 24931}),
    # "ee" = 65 65 = 25957, and 65 once more
    Row(0x185, "77 65 65 65 00 00 00", "CpvControl5",
        {"Action": 0x77, "Kind": 25957, "ZeroLearning": 0x65}),
    # "vv" = 76 76 = 30326; 3 rad/s = 3000 = 0xBB8
    Row(0x186, "77 76 76 00 00 0B B8", "CpvControl6",
        {"Action": 0x77, "Kind": 30326, "ProfileSpeed": 3.0}),
    # "dc" = 64 63 = 25699; 5 rad/s² = 500 = 0x1F4
    Row(0x186, "61 64 63 00 00 01 F4", "CpvControl6",
        {"Action": 0x61, "Kind": 25699, "Deceleration": 5.0}),
    # "pp" = 70 70 = 28784; -0.01 = -1
    Row(0x186, "61 70 70 FF FF FF FF", "CpvControl6",
        {"Action": 0x61, "Kind": 28784, "PositionKp": -0.01}),
    # "ki" = 6B 69 = 27497; the highest int32
    Row(0x186, "61 6B 69 7F FF FF FF", "CpvControl6",
        {"Action": 0x61, "Kind": 27497, "SpeedKi": 21474836.47}),
    Row(0x187, "77 65 65 65 00 00 00", "CpvGripper",
        {"Action": 0x77, "Kind": 25957, "ZeroLearning": 0x65}),
    # 01 01 01 = 65793
    Row(0x191, "01 01 01 00 00 00 00 00", "LeaderZero", {"Command": 65793}),
    # 3 rad/s = 3000 = 0xBB8; -1.5 A = -1500 = 0xFA24; -2.618 rad = -2618 = -0xA3A = 0xFFFFF5C6
    Row(0x251, "0B B8 FA 24 FF FF F5 C6", "DriverFast1",
        {"Speed": 3.0, "Current": -1.5, "Position": -2.618}),
    # 3.142 rad = 3142 = 0xC46
    Row(0x252, "FF FF 7F FF 00 00 0C 46", "DriverFast2",
        {"Speed": -0.001, "Current": 32.767, "Position": 3.142}),
    Row(0x253, "80 00 80 00 7F FF FF FF", "DriverFast3",
        {"Speed": -32.768, "Current": -32.768, "Position": 2147483.647}),
    Row(0x254, "00 01 00 02 00 00 00 03", "DriverFast4",
        {"Speed": 0.001, "Current": 0.002, "Position": 0.003}),
    Row(0x255, "03 E8 07 D0 FF FF FC 18", "DriverFast5",
        {"Speed": 1.0, "Current": 2.0, "Position": -1.0}),
    Row(0x256, "01 00 00 FF 80 00 00 00", "DriverFast6",
        {"Speed": 0.256, "Current": 0.255, "Position": -2147483.648}),
    # 24.0 V = 0xF0; 45 °C = 0x2D; 38 °C = 0x26; bits 0, 4 and 6; 1.2 A = 1200 = 0x4B0
    Row(0x261, "00 F0 00 2D 26 51 04 B0", "DriverSlow1",
        {"Voltage": 24.0, "DriverTemperature": 45, "MotorTemperature": 38, "Undervoltage": 1,
         "CollisionProtection": 1, "Enabled": 1, "BusCurrent": 1.2}),
    # 23.9 V = 0xEF; -5 °C = 0xFFFB; -10 °C = 0xF6; bits 1, 6 and 7
    Row(0x262, "00 EF FF FB F6 C2 00 00", "DriverSlow2",
        {"Voltage": 23.9, "DriverTemperature": -5, "MotorTemperature": -10,
         "MotorOvertemperature": 1, "Enabled": 1, "StallProtection": 1}),
    Row(0x263, "00 00 00 00 00 04 00 00", "DriverSlow3", {"Overcurrent": 1}),
    Row(0x264, "00 00 00 00 00 08 00 00", "DriverSlow4", {"DriverOvertemperature": 1}),
    Row(0x265, "00 00 00 00 00 20 00 00", "DriverSlow5", {"DriverFault": 1}),
    # 65.535 A = 0xFFFF: unsigned
    Row(0x266, "FF FF 80 00 80 00 FF FF", "DriverSlow6",
        {"Voltage": 6553.5, "DriverTemperature": -32768, "MotorTemperature": -128,
         "BusCurrent": 65.535}),
    # limits of joints 1 and 6: bits 0 and 5; communication of joints 2 and 4: bits 1 and 3
    Row(0x2A1, "07 0F 06 07 01 FF 21 0A", "ArmStatus",
        {"ControlMode": 7, "Status": 15, "MoveMode": 6, "TeachingState": 7, "MotionState": 1,
         "TrajectoryPoint": 255, "J1LimitExceeded": 1, "J6LimitExceeded": 1,
         "J2CommunicationFault": 1, "J4CommunicationFault": 1}),
    # 100 mm = 100000 = 0x186A0; -1.5 N·m = 0xFA24; bits 0 and 7
    Row(0x2A8, "00 01 86 A0 FA 24 81 00", "GripperFeedback",
        {"Opening": 100.0, "Torque": -1.5, "Undervoltage": 1, "Homed": 1}),
    # -5° = -5000 = 0xFFFFEC78; byte 7: an angle
    Row(0x2A8, "FF FF EC 78 00 00 40 01", "GripperFeedback",
        {"Angle": -5.0, "Enabled": 1, "Measure": 1}),
    # as 0x2A5-0x2A7
    Row(0x2AA, "00 01 5F 90 FF FF FC 18", "IkSolution12", {"J1": 90.0, "J2": -1.0}),
    Row(0x2AB, "FF FD 67 F0 00 00 01 F4", "IkSolution34", {"J3": -170.0, "J4": 0.5}),
    Row(0x2AC, "FF FE EE 90 00 01 D4 C0", "IkSolution56", {"J5": -70.0, "J6": 120.0}),
    Row(0x422, "01 00 00 00 00 00 00 00", "BusSilence", {"Mode": 1}),
    Row(0x470, "FC 20 10 00 00 00 00 00", "LinkageSetting",
        {"Role": 0xFC, "FeedbackOffset": 0x20, "ControlOffset": 0x10}),
    # 180° = 1800 = 0x708; -0.1° = -1; 3.00 rad/s = 300 = 0x12C
    Row(0x473, "02 07 08 FF FF 01 2C 00", "LimitFeedback",
        {"Joint": 2, "MaxAngle": 180.0, "MinAngle": -0.1, "MaxSpeed": 3.0}),
    # 0x7FFF leaves unchanged: 3276.7° and 327.67 rad/s; -170° = -1700 = -0x6A4 = 0xF95C
    Row(0x474, "03 7F FF F9 5C 7F FF 00", "LimitSetting",
        {"Joint": 3, "MaxAngle": 3276.7, "MinAngle": -170.0, "MaxSpeed": 327.67}),
    # 5.00 rad/s² = 500 = 0x1F4
    Row(0x475, "07 AE AE 01 F4 AE 00 00", "JointSetting",
        {"Joint": 7, "SetZero": 0xAE, "AccelerationValid": 0xAE, "MaxAcceleration": 5.0,
         "ClearError": 0xAE}),
    Row(0x476, "50 00 09 EE 01 02 AB CD", "SettingResponse",
        {"Index": 0x50, "TrajectoryPoint": 9, "Transfer": 0xEE, "NameIndex": 258, "Crc16": 43981}),
    Row(0x476, "87 00 00 00 00 00 00 00", "SettingResponse", {"Index": 0x87}),
    Row(0x477, "05 00 00 00 00 00 00 00", "ParameterCommand", {"Query": 5}),
    Row(0x477, "04 02 02 AE 01 00 00 00", "ParameterCommand",
        {"Query": 4, "Reset": 2, "EndFeedback": 2, "LoadValid": 0xAE, "Load": 1}),
    # 0x7FFF leaves unchanged: 32.767
    Row(0x479, "03 E8 7F FF 0B B8 7F FF", "EndLimitSetting",
        {"MaxLinearSpeed": 1.0, "MaxAngularSpeed": 32.767,
         "MaxLinearAcceleration": 3.0, "MaxAngularAcceleration": 32.767}),
    # 5.00 rad/s² = 500 = 0x1F4
    Row(0x47C, "05 01 F4 00 00 00 00 00", "AccelerationFeedback",
        {"Joint": 5, "MaxAcceleration": 5.0}),
    # 120 % = 0x78; 70 mm = 0x46
    Row(0x47D, "78 46 03 00 00 00 00 00", "TeachingSetting",
        {"TeachingRange": 120, "StrokeLimit": 70, "Friction": 3}),
    # 200 % = 0xC8; 100 mm = 0x64
    Row(0x47E, "C8 64 0A 00 00 00 00 00", "TeachingFeedback",
        {"TeachingRange": 200, "StrokeLimit": 100, "Friction": 10}),
    # 0xFF leaves unchanged
    Row(0x487, "00 0A 05 FF FF FF 00 00", "DragAssistanceSetting",
        {"J1": 0, "J2": 10, "J3": 5, "J4": 255, "J5": 255, "J6": 255}),
    Row(0x488, "0A 09 08 02 01 00 00 00", "DragAssistanceFeedback",
        {"J1": 10, "J2": 9, "J3": 8, "J4": 2, "J5": 1}),
    # ASCII "S-V1.6-3"
    Row(0x4AF, "53 2D 56 31 2E 36 2D 33", "FirmwareVersion",
        {"Byte0": 83, "Byte1": 45, "Byte2": 86, "Byte3": 49,
         "Byte4": 46, "Byte5": 54, "Byte6": 45, "Byte7": 51}),
]

UNTIL_1_8_7 = [
    # nibbles: position 4, velocity 3, kp 3, kd 3, torque 2, check 1; raw 0 is the lower end of each
    Row(0x15A, "00 00 00 00 00 00 00 00", "MitControl1",
        {"Position": -12.5, "Velocity": -45.0, "Kd": -5.0, "Torque": -8.0}),
    # all ones is the upper end; seven bytes 0xFF make 0xFF by exclusive or: check 0xF
    Row(0x15B, "FF FF FF FF FF FF FF FF", "MitControl2",
        {"Position": 12.5, "Velocity": 45.0, "Kp": 500.0, "Kd": 5.0, "Torque": 8.0, "Crc4": 15}),
    # 8000 800 052 947 80 E: 32768·25/65535 - 12.5, 2048·90/4095 - 45, 82·500/4095,
    # 2375·10/4095 - 5, 128·16/255 - 8; check 80^00^80^00^52^94^78 = BE
    Row(0x15C, "80 00 80 00 52 94 78 0E", "MitControl3",
        {"Position": 0.00019073777, "Velocity": 0.01098901099, "Kp": 10.01221001,
         "Kd": 0.7997557998, "Torque": 0.03137254902, "Crc4": 14}),
    # FFFF 000 000 000 00: check FF^FF = 00
    Row(0x15D, "FF FF 00 00 00 00 00 00", "MitControl4",
        {"Position": 12.5, "Velocity": -45.0, "Kd": -5.0, "Torque": -8.0}),
    # 0000 FFF 000 000 00: check FF^F0 = 0F
    Row(0x15E, "00 00 FF F0 00 00 00 0F", "MitControl5",
        {"Position": -12.5, "Velocity": 45.0, "Kd": -5.0, "Torque": -8.0, "Crc4": 15}),
    # 0000 000 FFF 000 00: check 0F^FF = F0
    Row(0x15F, "00 00 00 0F FF 00 00 00", "MitControl6",
        {"Position": -12.5, "Velocity": -45.0, "Kp": 500.0, "Kd": -5.0, "Torque": -8.0}),
]
"""What differs up to S-V1.8-7: a torque of 8 bits, and a check."""

ROWS = {Generation.ONE: BOTH + GENERATION_1, Generation.TWO: BOTH + GENERATION_2}
