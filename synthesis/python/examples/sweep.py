"""Transmission angle and swing of a four-bar over its crank angle and over the length of its crank, with NumPy."""

import mechwright
import numpy as np

linkage = {
    "schema": 1,
    "mechanism": "four-bar",
    "dimensions": {"ground": 100.0, "crank": 34.0, "coupler": 93.0, "rocker": 70.0},
}

motion = mechwright.analyse(linkage, crank_angles=np.arange(0, 360, 0.5))["motion"]
worst = np.argmin(np.minimum(motion["transmission-angle"], 180 - motion["transmission-angle"]))
print(f"worst transmission angle at crank angle {motion['crank-angle'][worst]:g} deg")

cranks = np.linspace(30, 36, 7)
swings = []
for crank in cranks:
    linkage["dimensions"]["crank"] = crank
    swings.append(mechwright.analyse(linkage)["quantities"]["swing"])
slope, swing = np.polyfit(cranks - 33, swings, 1)
print(f"swing {swing:.2f} deg with a crank of 33 mm, {slope:.2f} deg more for each mm")
