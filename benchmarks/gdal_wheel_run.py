"""Run the viewshed of a newer GDAL, bundled in a wheel, through its C interface.

Usage: python gdal_wheel_run.py LIBGDAL ARGUMENT...    (the arguments of `gdal raster viewshed`)
"""

from __future__ import annotations

import ctypes
import os
import sys

POINTER, TEXT = ctypes.c_void_p, ctypes.c_char_p


def main(library, arguments):
    folder = os.path.join(os.path.dirname(os.path.dirname(library)), "pyogrio")
    os.environ.setdefault("PROJ_DATA", os.path.join(folder, "proj_data"))
    os.environ.setdefault("GDAL_DATA", os.path.join(folder, "gdal_data"))
    gdal = ctypes.CDLL(library)
    for name, result, types in (
        ("GDALGetGlobalAlgorithmRegistry", POINTER, []),
        ("GDALAlgorithmRegistryInstantiateAlg", POINTER, [POINTER, TEXT]),
        ("GDALAlgorithmInstantiateSubAlgorithm", POINTER, [POINTER, TEXT]),
        ("GDALAlgorithmParseCommandLineArguments", ctypes.c_bool, [POINTER, ctypes.POINTER(TEXT)]),
        ("GDALAlgorithmRun", ctypes.c_bool, [POINTER, POINTER, POINTER]),
        ("GDALAlgorithmFinalize", ctypes.c_bool, [POINTER]),
    ):
        getattr(gdal, name).restype, getattr(gdal, name).argtypes = result, types
    gdal.GDALAllRegister()
    raster = gdal.GDALAlgorithmRegistryInstantiateAlg(gdal.GDALGetGlobalAlgorithmRegistry(), b"raster")
    algorithm = gdal.GDALAlgorithmInstantiateSubAlgorithm(raster, b"viewshed")
    words = (TEXT * (len(arguments) + 1))(*[argument.encode() for argument in arguments], None)
    if not gdal.GDALAlgorithmParseCommandLineArguments(algorithm, words):
        return 2
    done = gdal.GDALAlgorithmRun(algorithm, None, None) and gdal.GDALAlgorithmFinalize(algorithm)
    return 0 if done else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
