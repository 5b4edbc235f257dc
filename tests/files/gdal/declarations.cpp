// Compiled, not run: fumon's declarations of GDAL's functions after GDAL's own headers, where a
// function of another type is an error; and its constants beside theirs.

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdalwarper.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#define FUMON_GDAL_HEADERS
#define FUMON_GDAL_CLOSE_RETURNS_ERROR (GDAL_VERSION_NUM >= 3070000)
#include "files/gdal/gdal_declarations.h"

namespace ours {
#include "files/gdal/gdal_types.h"
}  // namespace ours

#define SAME(name) static_assert(static_cast<int>(ours::name) == static_cast<int>(::name))
SAME(CE_None);
SAME(CE_Failure);
SAME(CE_Fatal);
SAME(GDT_Byte);
SAME(GDT_UInt16);
SAME(GDT_Int16);
SAME(GDT_UInt32);
SAME(GDT_Int32);
SAME(GDT_Float32);
SAME(GDT_Float64);
SAME(GDT_CFloat32);
SAME(GDT_UInt64);
SAME(GDT_Int64);
SAME(GF_Read);
SAME(GF_Write);
SAME(GCI_PaletteIndex);
SAME(GCI_RedBand);
SAME(GCI_BlueBand);
SAME(GCI_AlphaBand);
SAME(GRA_Bilinear);
SAME(wkbPoint);
SAME(wkbLineString);
SAME(wkbPolygon);
SAME(wkbMultiPoint);
SAME(wkbMultiLineString);
SAME(wkbMultiPolygon);
SAME(wkbGeometryCollection);
SAME(OAO_Up);
SAME(OAO_Down);
SAME(OAMS_TRADITIONAL_GIS_ORDER);
static_assert(GDAL_OF_READONLY == 0 && GDAL_OF_RASTER == 2 && GDAL_OF_VECTOR == 4 &&
              OGRERR_NONE == 0);
static_assert(GMF_ALL_VALID == 1 && GMF_PER_DATASET == 2 && GMF_NODATA == 8);
