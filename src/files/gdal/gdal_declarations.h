#pragma once

// The functions of GDAL's C interface that are in use, as it declares them. tests/files/gdal
// compiles this file after GDAL's own headers, whose types it then takes.

#include <cstdint>

#ifndef FUMON_GDAL_HEADERS
#include "files/gdal/gdal_types.h"
#endif

extern "C" {
void* CPLGetErrorHandlerUserData();
void CPLPopErrorHandler();
void CPLPushErrorHandlerEx(CPLErrorHandler handler, void* user);
void CPLSetConfigOption(const char* key, const char* value);
void CSLDestroy(char** list);
void GDALAllRegister();
GDALDatasetH GDALAutoCreateWarpedVRT(GDALDatasetH source, const char* from, const char* to,
                                     GDALResampleAlg method, double max_error,
                                     const GDALWarpOptions* options);
#if FUMON_GDAL_CLOSE_RETURNS_ERROR
CPLErr GDALClose(GDALDatasetH dataset);
#else
void GDALClose(GDALDatasetH dataset);
#endif
GDALDatasetH GDALCreate(GDALDriverH driver, const char* name, int nx, int ny, int bands,
                        GDALDataType type, const char* const* options);
GDALDatasetH GDALCreateCopy(GDALDriverH driver, const char* name, GDALDatasetH source, int strict,
                            const char* const* options, GDALProgressFunc progress, void* data);
int GDALDataTypeIsComplex(GDALDataType type);
int GDALDatasetGetLayerCount(GDALDatasetH dataset);
OGRLayerH GDALDatasetGetLayer(GDALDatasetH dataset, int number);
GDALDriverH GDALGetDatasetDriver(GDALDatasetH dataset);
const char* GDALGetDescription(GDALMajorObjectH object);
GDALDriverH GDALGetDriverByName(const char* name);
int GDALGetColorEntryAsRGB(GDALColorTableH table, int entry, GDALColorEntry* colour);
int GDALGetColorEntryCount(GDALColorTableH table);
int GDALGetGCPCount(GDALDatasetH dataset);
CPLErr GDALGetGeoTransform(GDALDatasetH dataset, double* transform);
GDALRasterBandH GDALGetMaskBand(GDALRasterBandH band);
int GDALGetMaskFlags(GDALRasterBandH band);
char** GDALGetMetadata(GDALMajorObjectH object, const char* domain);
const char* GDALGetMetadataItem(GDALMajorObjectH object, const char* name, const char* domain);
GDALRasterBandH GDALGetRasterBand(GDALDatasetH dataset, int number);
GDALColorInterp GDALGetRasterColorInterpretation(GDALRasterBandH band);
GDALColorTableH GDALGetRasterColorTable(GDALRasterBandH band);
int GDALGetRasterCount(GDALDatasetH dataset);
GDALDataType GDALGetRasterDataType(GDALRasterBandH band);
double GDALGetRasterNoDataValue(GDALRasterBandH band, int* has);
std::int64_t GDALGetRasterNoDataValueAsInt64(GDALRasterBandH band, int* has);
std::uint64_t GDALGetRasterNoDataValueAsUInt64(GDALRasterBandH band, int* has);
double GDALGetRasterOffset(GDALRasterBandH band, int* success);
double GDALGetRasterScale(GDALRasterBandH band, int* success);
const char* GDALGetRasterUnitType(GDALRasterBandH band);
int GDALGetRasterXSize(GDALDatasetH dataset);
int GDALGetRasterYSize(GDALDatasetH dataset);
OGRSpatialReferenceH GDALGetSpatialRef(GDALDatasetH dataset);
GDALDriverH GDALIdentifyDriverEx(const char* file, unsigned int flags, const char* const* drivers,
                                 const char* const* siblings);
GDALDatasetH GDALOpenEx(const char* file, unsigned int flags, const char* const* drivers,
                        const char* const* options, const char* const* siblings);
CPLErr GDALRasterIO(GDALRasterBandH band, GDALRWFlag direction, int x, int y, int nx, int ny,
                    void* buffer, int buffer_nx, int buffer_ny, GDALDataType buffer_type,
                    int pixel_space, int line_space);
void GDALSetDescription(GDALMajorObjectH object, const char* text);
CPLErr GDALSetGeoTransform(GDALDatasetH dataset, double* transform);
CPLErr GDALSetRasterNoDataValue(GDALRasterBandH band, double value);
CPLErr GDALSetRasterUnitType(GDALRasterBandH band, const char* unit);
CPLErr GDALSetSpatialRef(GDALDatasetH dataset, OGRSpatialReferenceH crs);
void OCTDestroyCoordinateTransformation(OGRCoordinateTransformationH transformation);
OGRCoordinateTransformationH OCTNewCoordinateTransformation(OGRSpatialReferenceH from,
                                                            OGRSpatialReferenceH to);
int OCTTransform(OGRCoordinateTransformationH transformation, int count, double* x, double* y,
                 double* z);
void OGR_F_Destroy(OGRFeatureH feature);
const char* OGR_F_GetFieldAsString(OGRFeatureH feature, int field);
OGRGeometryH OGR_F_GetGeometryRef(OGRFeatureH feature);
int OGR_F_IsFieldSetAndNotNull(OGRFeatureH feature, int field);
int OGR_FD_GetFieldCount(OGRFeatureDefnH definition);
OGRFieldDefnH OGR_FD_GetFieldDefn(OGRFeatureDefnH definition, int field);
const char* OGR_Fld_GetNameRef(OGRFieldDefnH field);
void OGR_G_DestroyGeometry(OGRGeometryH geometry);
int OGR_G_GetGeometryCount(OGRGeometryH geometry);
OGRGeometryH OGR_G_GetGeometryRef(OGRGeometryH geometry, int part);
OGRwkbGeometryType OGR_G_GetGeometryType(OGRGeometryH geometry);
OGRGeometryH OGR_G_GetLinearGeometry(OGRGeometryH geometry, double max_angle, char** options);
int OGR_G_GetPointCount(OGRGeometryH geometry);
double OGR_G_GetX(OGRGeometryH geometry, int point);
double OGR_G_GetY(OGRGeometryH geometry, int point);
int OGR_G_HasCurveGeometry(OGRGeometryH geometry, int look_for_non_linear);
OGRFeatureDefnH OGR_L_GetLayerDefn(OGRLayerH layer);
const char* OGR_L_GetName(OGRLayerH layer);
OGRFeatureH OGR_L_GetNextFeature(OGRLayerH layer);
OGRSpatialReferenceH OGR_L_GetSpatialRef(OGRLayerH layer);
OGRErr OGR_L_SetAttributeFilter(OGRLayerH layer, const char* condition);
OGRSpatialReferenceH OSRCloneGeogCS(OGRSpatialReferenceH crs);
void OSRDestroySpatialReference(OGRSpatialReferenceH crs);
OGRErr OSRExportToWktEx(OGRSpatialReferenceH crs, char** text, const char* const* options);
double OSRGetAngularUnits(OGRSpatialReferenceH crs, char** name);
const char* OSRGetAxis(OGRSpatialReferenceH crs, const char* key, int axis,
                       OGRAxisOrientation* orientation);
double OSRGetInvFlattening(OGRSpatialReferenceH crs, OGRErr* fault);
double OSRGetLinearUnits(OGRSpatialReferenceH crs, char** name);
double OSRGetSemiMajor(OGRSpatialReferenceH crs, OGRErr* fault);
double OSRGetTargetLinearUnits(OGRSpatialReferenceH crs, const char* key, char** name);
OGRErr OSRImportFromESRI(OGRSpatialReferenceH crs, char** lines);
int OSRIsCompound(OGRSpatialReferenceH crs);
int OSRIsGeographic(OGRSpatialReferenceH crs);
int OSRIsLocal(OGRSpatialReferenceH crs);
int OSRIsProjected(OGRSpatialReferenceH crs);
OGRSpatialReferenceH OSRNewSpatialReference(const char* wkt);
void OSRSetAxisMappingStrategy(OGRSpatialReferenceH crs, OSRAxisMappingStrategy strategy);
OGRErr OSRSetFromUserInput(OGRSpatialReferenceH crs, const char* text);
void VSIFree(void* memory);
GByte* VSIGetMemFileBuffer(const char* name, vsi_l_offset* length, int take);
int VSIUnlink(const char* name);
}
