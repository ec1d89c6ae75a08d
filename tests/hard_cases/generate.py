#!/usr/bin/env python3
"""Writes the answers of the hard cases, tests/hard_cases/data, in fifty digits. Needs mpmath (1.3).

    tests/hard_cases/generate.py

Every answer comes from the double dimensions in its row, taken exactly, by textbook formulas (law of cosines, complex
numbers) in 120 digits, where their cancellation does no harm; nothing of the program is used. Beside each answer stands
how far it moves when every input moves by its rounding (2^-53 of itself, the worst of all signs): what even a perfect
method has to be forgiven. A crank angle `pi` means exactly that, and neither it nor 0 is moved.
"""
import cams
import drives
import four_bars
import syntheses

if __name__ == "__main__":
    for family in (four_bars, drives, cams, syntheses):
        family.write_tables()
