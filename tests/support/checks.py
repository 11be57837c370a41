"""Checks for tests in Python: a check that fails prints its message, and the test goes on."""
failures = []


def check(condition, text):
    if not condition:
        failures.append(text)
        print("FAILED: " + text)
