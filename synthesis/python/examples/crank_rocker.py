"""The crank-rocker of 60 degrees swing and time ratio 19/17 with the best transmission angle."""

import mechwright

problem = {
    "schema": 1,
    "mechanism": "four-bar",
    "dimensions": {
        "ground": 100.0,
        "crank": {"min": 5, "max": 60},
        "coupler": {"min": 20, "max": 300},
        "rocker": {"min": 20, "max": 300},
    },
    "require": [
        {"quantity": "swing", "equal": 60},
        {"quantity": "time-ratio", "equal": 19 / 17},
    ],
    "objective": {"maximize": "transmission-angle-worst"},
}

result = mechwright.solve(problem)

print(result["status"], result["verification"]["passed"])
for name in ("crank", "coupler", "rocker"):
    print(f"{name:8} {result['design'][name]:10.6f} mm")
print(f"transmission angle at least {result['objective']['value']:.6f} deg")
