#!/usr/bin/env python3
"""Runs an example and compares its output with the sample in the head of its source.

    check_sample.py PROGRAM SOURCE

The sample is what follows the line '// Sample output:', each line after '//   '. Words must be the same; numbers may
differ by 2 % or by one in their last digit shown, as compilers and processors round differently.
"""
import re
import subprocess
import sys

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def sample_of(source):
    lines = open(source, encoding="utf-8").read().splitlines()
    begin = lines.index("// Sample output:") + 1
    sample = []
    for line in lines[begin:]:
        if not line.startswith("//   "):
            break
        sample.append(line[len("//   "):])
    return sample


def last_digit(text):
    """One unit in the last digit: 0.1 for '-1.5', 0.001 for '2e-03', 1 for '930'."""
    mantissa, _, exponent = text.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals)


def same(expected, found):
    if NUMBER.sub("#", expected) != NUMBER.sub("#", found):
        return False
    for a, b in zip(NUMBER.findall(expected), NUMBER.findall(found)):
        if abs(float(a) - float(b)) > max(0.02 * abs(float(a)), 1.001 * last_digit(a)):
            return False
    return True


def main():
    program, source = sys.argv[1:]
    expected = sample_of(source)
    run = subprocess.run([program], capture_output=True, text=True)
    found = run.stdout.splitlines()
    good = run.returncode == 0 and expected and len(found) == len(expected) and all(map(same, expected, found))
    if not good:
        print(f"exit code {run.returncode}; printed:", *found, run.stderr, "expected:", *expected, sep="\n")
    return 0 if good else 1


sys.exit(main())
