"""A crank-rocker whose coupler point goes round an ellipse that is given as an array of points."""

import mechwright
import numpy as np

angle = np.linspace(0, 2 * np.pi, 36, endpoint=False)
ellipse = np.column_stack([30 * np.cos(angle), 15 * np.sin(angle)])

result = mechwright.solve({
    "schema": 1,
    "mechanism": "four-bar",
    "dimensions": {
        "ground": {"min": 20, "max": 200},
        "crank": {"min": 5, "max": 60},
        "coupler": {"min": 20, "max": 200},
        "rocker": {"min": 20, "max": 200},
        "point-along": {"min": -200, "max": 200},
        "point-across": {"min": -200, "max": 200},
        "origin-x": {"min": -200, "max": 200},
        "origin-y": {"min": -200, "max": 200},
        "tilt": {"min": 0, "max": 360},
    },
    "path": {"points": ellipse, "timing": "none", "closed": True},
    "objective": {"minimize": "path-rms"},
})

miss = np.hypot(*(result["path"]["reached"] - ellipse).T)
print(result["status"], result["design"]["kind"])
print(f"off the ellipse by {np.sqrt(np.mean(miss**2)):.3f} mm (root mean square), {miss.max():.3f} mm at most")
