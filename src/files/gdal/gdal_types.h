#pragma once

// GDAL's types and constants, as its stable C interface has them (GDAL 3.4 to 3.11). Only what is
// in use; tests/files/gdal compares them with GDAL's own headers.

using GByte = unsigned char;
using vsi_l_offset = unsigned long long;
using OGRErr = int;
using CPLErrorNum = int;
using GDALMajorObjectH = void*;
using GDALDatasetH = void*;
using GDALRasterBandH = void*;
using GDALDriverH = void*;
using GDALColorTableH = void*;
using OGRSpatialReferenceH = void*;
using OGRCoordinateTransformationH = void*;
using OGRLayerH = void*;
using OGRFeatureH = void*;
using OGRFeatureDefnH = void*;
using OGRFieldDefnH = void*;
using OGRGeometryH = void*;
struct GDALWarpOptions;
using GDALProgressFunc = int (*)(double, const char*, void*);

enum CPLErr { CE_None = 0, CE_Debug = 1, CE_Warning = 2, CE_Failure = 3, CE_Fatal = 4 };
using CPLErrorHandler = void (*)(CPLErr, CPLErrorNum, const char*);

enum GDALDataType {
    GDT_Unknown = 0,
    GDT_Byte = 1,
    GDT_UInt16 = 2,
    GDT_Int16 = 3,
    GDT_UInt32 = 4,
    GDT_Int32 = 5,
    GDT_Float32 = 6,
    GDT_Float64 = 7,
    GDT_CFloat32 = 10,
    GDT_UInt64 = 12,
    GDT_Int64 = 13,
};
enum GDALRWFlag { GF_Read = 0, GF_Write = 1 };
enum GDALColorInterp {
    GCI_Undefined = 0,
    GCI_GrayIndex = 1,
    GCI_PaletteIndex = 2,
    GCI_RedBand = 3,
    GCI_BlueBand = 5,
    GCI_AlphaBand = 6,
};
struct GDALColorEntry {
    short c1, c2, c3, c4;
};
enum GDALResampleAlg { GRA_NearestNeighbour = 0, GRA_Bilinear = 1 };
/// Of two dimensions; others have thousands, and the highest bit, added.
enum OGRwkbGeometryType : unsigned int {
    wkbUnknown = 0,
    wkbPoint = 1,
    wkbLineString = 2,
    wkbPolygon = 3,
    wkbMultiPoint = 4,
    wkbMultiLineString = 5,
    wkbMultiPolygon = 6,
    wkbGeometryCollection = 7,
};
enum OGRAxisOrientation { OAO_Other = 0, OAO_Up = 5, OAO_Down = 6 };
enum OSRAxisMappingStrategy { OAMS_TRADITIONAL_GIS_ORDER = 0 };

#ifndef GDAL_OF_RASTER  // which are macros in GDAL's headers
constexpr unsigned int GDAL_OF_READONLY = 0x00;
constexpr unsigned int GDAL_OF_RASTER = 0x02;
constexpr unsigned int GDAL_OF_VECTOR = 0x04;
constexpr int GMF_ALL_VALID = 0x01;
constexpr int GMF_PER_DATASET = 0x02;
constexpr int GMF_NODATA = 0x08;
constexpr OGRErr OGRERR_NONE = 0;
#endif
