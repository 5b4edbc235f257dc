#pragma once

#include <string>

#include "files/gdal/gdal_declarations.h"

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
    FUMON_GDAL(CSLDestroy);
    FUMON_GDAL(GDALAllRegister);
    FUMON_GDAL(GDALAutoCreateWarpedVRT);
    FUMON_GDAL(GDALClose);
    FUMON_GDAL(GDALCreate);
    FUMON_GDAL(GDALCreateCopy);
    FUMON_GDAL(GDALDataTypeIsComplex);
    FUMON_GDAL(GDALDatasetGetLayer);
    FUMON_GDAL(GDALDatasetGetLayerCount);
    FUMON_GDAL(GDALGetColorEntryAsRGB);
    FUMON_GDAL(GDALGetColorEntryCount);
    FUMON_GDAL(GDALGetDatasetDriver);
    FUMON_GDAL(GDALGetDescription);
    FUMON_GDAL(GDALGetDriverByName);
    FUMON_GDAL(GDALGetGCPCount);
    FUMON_GDAL(GDALGetGeoTransform);
    FUMON_GDAL(GDALGetMaskBand);
    FUMON_GDAL(GDALGetMaskFlags);
    FUMON_GDAL(GDALGetMetadata);
    FUMON_GDAL(GDALGetMetadataItem);
    FUMON_GDAL(GDALGetRasterBand);
    FUMON_GDAL(GDALGetRasterColorInterpretation);
    FUMON_GDAL(GDALGetRasterColorTable);
    FUMON_GDAL(GDALGetRasterCount);
    FUMON_GDAL(GDALGetRasterDataType);
    FUMON_GDAL(GDALGetRasterNoDataValue);
    FUMON_GDAL(GDALGetRasterNoDataValueAsInt64);
    FUMON_GDAL(GDALGetRasterNoDataValueAsUInt64);
    FUMON_GDAL(GDALGetRasterOffset);
    FUMON_GDAL(GDALGetRasterScale);
    FUMON_GDAL(GDALGetRasterUnitType);
    FUMON_GDAL(GDALGetRasterXSize);
    FUMON_GDAL(GDALGetRasterYSize);
    FUMON_GDAL(GDALGetSpatialRef);
    FUMON_GDAL(GDALIdentifyDriverEx);
    FUMON_GDAL(GDALOpenEx);
    FUMON_GDAL(GDALRasterIO);
    FUMON_GDAL(GDALSetDescription);
    FUMON_GDAL(GDALSetGeoTransform);
    FUMON_GDAL(GDALSetRasterNoDataValue);
    FUMON_GDAL(GDALSetRasterUnitType);
    FUMON_GDAL(GDALSetSpatialRef);
    FUMON_GDAL(OCTDestroyCoordinateTransformation);
    FUMON_GDAL(OCTNewCoordinateTransformation);
    FUMON_GDAL(OCTTransform);
    FUMON_GDAL(OGR_F_Destroy);
    FUMON_GDAL(OGR_F_GetFieldAsString);
    FUMON_GDAL(OGR_F_GetGeometryRef);
    FUMON_GDAL(OGR_F_IsFieldSetAndNotNull);
    FUMON_GDAL(OGR_FD_GetFieldCount);
    FUMON_GDAL(OGR_FD_GetFieldDefn);
    FUMON_GDAL(OGR_Fld_GetNameRef);
    FUMON_GDAL(OGR_G_DestroyGeometry);
    FUMON_GDAL(OGR_G_GetGeometryCount);
    FUMON_GDAL(OGR_G_GetGeometryRef);
    FUMON_GDAL(OGR_G_GetGeometryType);
    FUMON_GDAL(OGR_G_GetLinearGeometry);
    FUMON_GDAL(OGR_G_GetPointCount);
    FUMON_GDAL(OGR_G_GetX);
    FUMON_GDAL(OGR_G_GetY);
    FUMON_GDAL(OGR_G_HasCurveGeometry);
    FUMON_GDAL(OGR_L_GetLayerDefn);
    FUMON_GDAL(OGR_L_GetName);
    FUMON_GDAL(OGR_L_GetNextFeature);
    FUMON_GDAL(OGR_L_GetSpatialRef);
    FUMON_GDAL(OGR_L_SetAttributeFilter);
    FUMON_GDAL(OSRCloneGeogCS);
    FUMON_GDAL(OSRDestroySpatialReference);
    FUMON_GDAL(OSRExportToWktEx);
    FUMON_GDAL(OSRGetAngularUnits);
    FUMON_GDAL(OSRGetAxis);
    FUMON_GDAL(OSRGetInvFlattening);
    FUMON_GDAL(OSRGetLinearUnits);
    FUMON_GDAL(OSRGetSemiMajor);
    FUMON_GDAL(OSRGetTargetLinearUnits);
    FUMON_GDAL(OSRImportFromESRI);
    FUMON_GDAL(OSRIsCompound);
    FUMON_GDAL(OSRIsGeographic);
    FUMON_GDAL(OSRIsLocal);
    FUMON_GDAL(OSRIsProjected);
    FUMON_GDAL(OSRNewSpatialReference);
    FUMON_GDAL(OSRSetAxisMappingStrategy);
    FUMON_GDAL(OSRSetFromUserInput);
    FUMON_GDAL(VSIFree);
    FUMON_GDAL(VSIGetMemFileBuffer);
    FUMON_GDAL(VSIUnlink);
#undef FUMON_GDAL
};

/// Throws InputError where GDAL is not installed, with the package to install.
const GdalFunctions& gdal();

/// Whether GDAL can be loaded.
bool has_gdal();

/// "needs GDAL, which is not installed: apt-get install libgdal32 (Debian 12) …"; empty where it
/// is.
std::string missing_gdal();

}  // namespace fumon
