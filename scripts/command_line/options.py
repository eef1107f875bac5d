# SPDX-License-Identifier: BSD-3-Clause
"""Options that refuse a bad value in one line."""
import argparse
import math

from .refusal import Refusal


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise Refusal(message)


def number(lowest, highest, kind=float):
    """A type for options: a number within limits."""
    def parse(text):
        try:
            value = kind(text)
        except ValueError:
            value = math.nan
        if not lowest <= value <= highest:
            word = "whole number" if kind is int else "number"
            raise argparse.ArgumentTypeError(
                f"expected a {word} from {lowest:g} to {highest:g}, got '{text}'")
        return value
    return parse


def choice(text):
    """A type for options: true or false, as roslaunch writes them."""
    words = {"true": True, "1": True, "false": False, "0": False}
    if text.lower() not in words:
        raise argparse.ArgumentTypeError(f"expected true or false, got '{text}'")
    return words[text.lower()]
