# SPDX-License-Identifier: BSD-3-Clause
"""3D line segments from oriented aerial images, judged against LIDAR.

    result = ridgeline.evaluate("roofs.gpkg", "tile.laz")
    print(result)                                # the accuracy table
    result.lines["mean_distance_m"]              # an array with one number per line
    result.to_geopackage("judged.gpkg")          # the error map

Coordinates are map coordinates in the units of the files; distances are metres. An invalid value
raises ValueError, an invalid file InputFileError (an OSError) or FileNotFoundError. Long calls
release the GIL and stop at Ctrl-C.
"""

from ridgeline._core import InputFileError
from ridgeline._core import version as __version__
from ridgeline.cloud import Cloud, read_cloud
from ridgeline.evaluation import Result, evaluate
from ridgeline.gates import GateReport, gate
from ridgeline.lines import Lines, read_lines, write_lines
from ridgeline.reconstruction import View, reconstruct
from ridgeline.scan import edges

__all__ = [
    "Cloud",
    "GateReport",
    "InputFileError",
    "Lines",
    "Result",
    "View",
    "__version__",
    "edges",
    "evaluate",
    "gate",
    "read_cloud",
    "read_lines",
    "reconstruct",
    "write_lines",
]
