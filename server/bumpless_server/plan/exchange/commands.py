"""MAVLink's mission commands, as far as people meet them in plans, where they stand by number.

Source: MAVLink common message set, MAV_CMD and MAV_FRAME.
"""

PLACES = {  # commands that say where to go, and what of them we do not do
    16: "",
    17: "loitering without end is not done",
    18: "loitering turns are not done",
    19: "loitering for a time is not done",
    21: "landing is not done; its place is a waypoint",
    22: "taking off is not done; its place is a waypoint",
    31: "loitering to a height is not done",
    82: "the spline is flown as straight legs",
    84: "taking off is not done; its place is a waypoint",
    85: "landing is not done; its place is a waypoint",
}
SPEED = 178
NAMES = {
    16: "NAV_WAYPOINT", 17: "NAV_LOITER_UNLIM", 18: "NAV_LOITER_TURNS", 19: "NAV_LOITER_TIME",
    20: "NAV_RETURN_TO_LAUNCH", 21: "NAV_LAND", 22: "NAV_TAKEOFF", 31: "NAV_LOITER_TO_ALT",
    82: "NAV_SPLINE_WAYPOINT", 84: "NAV_VTOL_TAKEOFF", 85: "NAV_VTOL_LAND", 92: "NAV_GUIDED_ENABLE",
    93: "NAV_DELAY", 112: "CONDITION_DELAY", 114: "CONDITION_DISTANCE", 115: "CONDITION_YAW",
    176: "DO_SET_MODE", 177: "DO_JUMP", 178: "DO_CHANGE_SPEED", 179: "DO_SET_HOME", 181: "DO_SET_RELAY",
    183: "DO_SET_SERVO", 189: "DO_LAND_START", 195: "DO_SET_ROI_LOCATION", 197: "DO_SET_ROI_NONE",
    201: "DO_SET_ROI", 203: "DO_DIGICAM_CONTROL", 205: "DO_MOUNT_CONTROL", 206: "DO_SET_CAM_TRIGG_DIST",
    207: "DO_FENCE_ENABLE", 211: "DO_GRIPPER", 530: "SET_CAMERA_MODE", 1000: "DO_GIMBAL_MANAGER_PITCHYAW",
    2000: "IMAGE_START_CAPTURE", 2001: "IMAGE_STOP_CAPTURE", 2500: "VIDEO_START_CAPTURE",
    2501: "VIDEO_STOP_CAPTURE", 5000: "NAV_FENCE_RETURN_POINT", 5001: "NAV_FENCE_POLYGON_VERTEX_INCLUSION",
    5002: "NAV_FENCE_POLYGON_VERTEX_EXCLUSION", 5003: "NAV_FENCE_CIRCLE_INCLUSION",
    5004: "NAV_FENCE_CIRCLE_EXCLUSION", 5100: "NAV_RALLY_POINT",
}  # fmt: skip
FENCES, RALLIES = range(5000, 5005), (5100,)
LOCAL_FRAMES = {1: "LOCAL_NED", 4: "LOCAL_ENU"}
GLOBAL_FRAMES = (0, 3, 5, 6, 10, 11)


def name_of(command: int) -> str:
    """A command's name, or its number."""
    return NAMES.get(command, f"command {command}")
