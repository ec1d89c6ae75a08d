"""What the generators share: arithmetic in 120 digits, how far answers move, the cells of a table."""
import itertools
import os

from mpmath import acos, fabs, mp, mpf, nstr, pi

mp.dps = 120
ROUNDING = mpf(2) ** -53
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data")


def between_sides(a, b, c):
    """The angle between the sides a and b of a triangle, opposite to c; 0 or pi where it does not close."""
    cosine = (a * a + b * b - c * c) / (2 * a * b)
    return mpf(0) if cosine >= 1 else +pi if cosine <= -1 else acos(cosine)


def exact_angle(angle):
    return +pi if angle == "pi" else mpf(angle)


def moves(function, inputs, fixed=()):
    """How far each answer moves when each input moves by its rounding."""
    here = function(*inputs)
    worst = [mpf(0)] * len(here)
    free = [i for i in range(len(inputs)) if i not in fixed and inputs[i] != 0]
    for signs in itertools.product((-1, 1), repeat=len(free)):
        moved = list(inputs)
        for i, sign in zip(free, signs):
            moved[i] = inputs[i] * (1 + sign * ROUNDING)
        for i, there in enumerate(function(*moved)):
            if there is None or here[i] is None:
                continue
            worst[i] = max(worst[i], fabs(there - here[i]))
    return worst


def moves_alone(function, inputs, fixed=()):
    """The same for many inputs: the sum of how far each of them alone moves an answer."""
    here = function(*inputs)
    total = [mpf(0)] * len(here)
    for i in range(len(inputs)):
        if i in fixed or inputs[i] == 0:
            continue
        theres = [function(*inputs[:i], inputs[i] * (1 + sign * ROUNDING), *inputs[i + 1:]) for sign in (-1, 1)]
        for j, answer in enumerate(here):
            ways = [fabs(there[j] - answer) for there in theres if answer is not None and there[j] is not None]
            total[j] += max(ways, default=mpf(0))
    return total


def written(x):
    if x is None:
        return ""
    return "0" if x == 0 else nstr(x, 50, strip_zeros=True)


def short(x):
    return "0" if x == 0 else nstr(x, 3)


def with_moves(answers):
    return [column for answer in answers for column in (answer, answer + "_moves")]


def write(file, header, rows, about):
    with open(os.path.join(FOLDER, file), "w", encoding="ascii", newline="\n") as out:
        out.write(f"# {about} Written by tests/hard_cases/generate.py.\n")
        out.write(",".join(header) + "\n")
        for row in rows:
            assert len(row) == len(header), row
            out.write(",".join(cell.replace(",", ";") for cell in row) + "\n")
