"""Memories: what a bandit keeps of the credits that its strategies earned."""

from divbandit.bandits.memories.discounted import Discounted
from divbandit.bandits.memories.protocol import Memory
from divbandit.bandits.memories.recent_window import RecentWindow
from divbandit.bandits.memories.whole_past import WholePast
from divbandit.bandits.memories.window import Window

__all__ = ["Discounted", "Memory", "RecentWindow", "WholePast", "Window"]
