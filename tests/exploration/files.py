"""Files that are no saved explorations."""

from functools import partial

import divbandit as db
from tests import files

refused = partial(files.refused, db.Exploration.load)
