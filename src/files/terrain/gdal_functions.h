#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gdalwarper.h>
#include <ogr_srs_api.h>

namespace fumon {

/// The functions of GDAL that are in use. GDAL is loaded when they are first asked for, since it
/// brings a hundred libraries and most runs need none of them.
struct GdalFunctions {
    static void* address_of(const char* name);

#define FUMON_GDAL(name) \
    decltype(&::name) name = reinterpret_cast<decltype(&::name)>(address_of(#name))
    FUMON_GDAL(CPLGetErrorHandlerUserData);
    FUMON_GDAL(CPLPopErrorHandler);
    FUMON_GDAL(CPLPushErrorHandlerEx);
    FUMON_GDAL(CPLSetConfigOption);
    FUMON_GDAL(GDALAutoCreateWarpedVRT);
    FUMON_GDAL(GDALClose);
    FUMON_GDAL(GDALCreate);
    FUMON_GDAL(GDALCreateCopy);
    FUMON_GDAL(GDALDataTypeIsComplex);
    FUMON_GDAL(GDALGetDriverByName);
    FUMON_GDAL(GDALGetGCPCount);
    FUMON_GDAL(GDALGetGeoTransform);
    FUMON_GDAL(GDALGetMaskBand);
    FUMON_GDAL(GDALGetMaskFlags);
    FUMON_GDAL(GDALGetRasterBand);
    FUMON_GDAL(GDALGetRasterColorInterpretation);
    FUMON_GDAL(GDALGetRasterCount);
    FUMON_GDAL(GDALGetRasterDataType);
    FUMON_GDAL(GDALGetRasterNoDataValue);
    FUMON_GDAL(GDALGetRasterOffset);
    FUMON_GDAL(GDALGetRasterScale);
    FUMON_GDAL(GDALGetRasterUnitType);
    FUMON_GDAL(GDALGetRasterXSize);
    FUMON_GDAL(GDALGetRasterYSize);
    FUMON_GDAL(GDALGetSpatialRef);
    FUMON_GDAL(GDALOpenEx);
    FUMON_GDAL(GDALRasterIO);
    FUMON_GDAL(GDALRegister_COG);
    FUMON_GDAL(GDALRegister_GTiff);
    FUMON_GDAL(GDALRegister_MEM);
    FUMON_GDAL(GDALRegister_VRT);
    FUMON_GDAL(GDALSetGeoTransform);
    FUMON_GDAL(GDALSetRasterNoDataValue);
    FUMON_GDAL(GDALSetRasterUnitType);
    FUMON_GDAL(GDALSetSpatialRef);
    FUMON_GDAL(OSRDestroySpatialReference);
    FUMON_GDAL(OSRExportToWktEx);
    FUMON_GDAL(OSRGetAngularUnits);
    FUMON_GDAL(OSRGetLinearUnits);
    FUMON_GDAL(OSRImportFromWkt);
    FUMON_GDAL(OSRIsGeographic);
    FUMON_GDAL(OSRIsLocal);
    FUMON_GDAL(OSRIsProjected);
    FUMON_GDAL(OSRNewSpatialReference);
    FUMON_GDAL(OSRSetFromUserInput);
    FUMON_GDAL(VSIFree);
    FUMON_GDAL(VSIGetMemFileBuffer);
    FUMON_GDAL(VSIUnlink);
#undef FUMON_GDAL
};

/// Throws Error where GDAL cannot be loaded.
const GdalFunctions& gdal();

}  // namespace fumon
