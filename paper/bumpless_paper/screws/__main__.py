"""`python -m bumpless_paper.screws`: measured screws and the plant's form, quadrant by quadrant."""

import numpy as np

from bumpless_paper.screws.curve import NAMES, measured, numbers_of, of_the_plant

ANGLES = np.arange(0.0, 360.0, 10.0)
SLOPES = (0.0, 0.3)  # -dK_T/dJ against the flow


def main() -> None:
    """Print C_T* at every 10 deg, and the deviation of each quadrant."""
    beta = np.radians(ANGLES)
    for name in NAMES:
        curve, found = measured(name, beta)[0], numbers_of(name)
        print(
            f"{name}: bollard {found.bollard:.3f} ahead, {found.bollard_astern:.3f} astern; no thrust at "
            f"{np.degrees(np.arctan(found.zero_thrust)):.1f} deg; stopped: drag {found.stopped_drag:.2f}, "
            f"torque {found.stopped_torque:.3f}"
        )
        forms = [of_the_plant(numbers_of(name, slope), beta) for slope in SLOPES]
        print("beta/deg  measured  " + "  ".join(f"slope {slope:g}" for slope in SLOPES))
        for i, angle in enumerate(ANGLES):
            print(f"{angle:8.0f}  {curve[i]:8.2f}  " + "  ".join(f"{form[i]:7.2f}" for form in forms))
        for slope, form in zip(SLOPES, forms, strict=True):
            off = [float(np.sqrt(np.mean((form - curve)[q * 9 : q * 9 + 10] ** 2))) for q in range(4)]
            print(f"RMS by quadrant, slope {slope:g}: " + ", ".join(f"{x:.3f}" for x in off))


if __name__ == "__main__":
    main()
