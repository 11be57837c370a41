"""Checks of tests in Python: what fails is said, and the test goes on."""
failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED: " + text)
