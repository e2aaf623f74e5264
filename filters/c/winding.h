// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The library libwinding: winding numbers of surfaces and point clouds, and what is made of them,
 * for C99 and everything that calls C. The page docs/library.md shows it at work.
 *
 * Sources are arrays of points and faces, or of points with normals. winding_faces() and
 * winding_points() make a field of them, which is built once, never changes, and may be used by any
 * number of threads at once. All other functions may be called by any threads, too. The library has
 * no state of its own.
 *
 * Arrays that are given are read where they lie, during the call only. Lengths are in the unit of
 * the points. Every function that can fail returns a winding_status. Where it is not WINDING_OK, no
 * result was made, and a winding_refusal says in one line what is wrong and what to do.
 *
 * Structs whose first member is `size` grow in later versions. A caller has them filled by their
 * function ending in _init, which is given the size that he was compiled with, and then sets what
 * is to differ from the defaults.
 *
 * Promise: a program that was compiled with a version 1.x of this header runs with the library of
 * any later 1.y, and gets the same results up to the tolerance. Functions, constants and members
 * are only added. WINDING_ABI changes where that cannot be kept.
 *
 * Results have the same bits for any number of threads and any extent of a grid, and have the bits
 * of the project's C++ filters on the same machine.
 */
#ifndef WINDING_H
#define WINDING_H

#include <stddef.h>
#include <stdint.h>

/** Marks what the library exports. */
#if defined(_WIN32)
#if defined(WINDING_BUILDS_LIBRARY)
#define WINDING_API __declspec(dllexport)
#else
#define WINDING_API __declspec(dllimport)
#endif
#else
#define WINDING_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C"
{
#endif

/** The version of the binary interface that this header describes. */
#define WINDING_ABI 1

  /** Returns the version of the binary interface of the library: WINDING_ABI, or do not use it. */
  WINDING_API int32_t winding_abi(void);

  /** Returns the version of the library, as "1.0.0". */
  WINDING_API const char* winding_version(void);

  /** How a call ended. */
  typedef enum winding_status
  {
    WINDING_OK = 0,          /**< the result is there */
    WINDING_REFUSED = 1,     /**< the input or an option cannot be worked with */
    WINDING_INTERRUPTED = 2, /**< the progress function asked for it */
    WINDING_NO_MEMORY = 3,   /**< an allocation failed */
    WINDING_MISUSED = 4,     /**< the call breaks a rule of this header, as by a null pointer */
    WINDING_FAILED = 5       /**< a fault of the library; please report it */
  } winding_status;

  /** Why a call ended as it did. Its texts are empty after WINDING_OK and WINDING_INTERRUPTED. */
  typedef struct winding_refusal
  {
    /** The member of an options struct that is at fault, as "tolerance"; empty for none. */
    char parameter[32];
    /** One line of UTF-8 that says what is wrong and what to do, cut off where it is longer. */
    char text[992];
  } winding_refusal;

  /** The words of messages: what options are called in them. */
  typedef enum winding_words
  {
    WINDING_WORDS_C = 0,       /**< the members of options structs */
    WINDING_WORDS_PYTHON = 1,  /**< the keywords of the package vtkwinding */
    WINDING_WORDS_PARAVIEW = 2 /**< the labels of the panels in ParaView */
  } winding_words;

  /** The way in which a call works. A null pointer in its place stands for the defaults. */
  typedef struct winding_run
  {
    uint32_t size;             /**< bytes of the struct that its caller knows */
    int32_t number_of_threads; /**< most threads; 0 or less: one for each core. Default: 0 */
    int32_t words;             /**< a winding_words. Default: WINDING_WORDS_C */
    /**
   * Is called with the share of the work that is done, 0 to 1, on the thread that called. It
   * returns 0 to go on, and anything else to have the call end with WINDING_INTERRUPTED. It must
   * not jump out. Default: null, for none.
   */
    int32_t (*progress)(double share, void* user);
    /**
   * Is called with a warning of one line, on the thread that called: something that makes the
   * result differ from what a user may expect. Default: null, for none.
   */
    void (*warn)(const char* text, void* user);
    void* user;      /**< is given to both. Default: null */
    double interval; /**< least seconds from one call of progress to the next. Default: 0.05 */
    /**
   * Evaluations that are expected to take more seconds are refused in their first seconds; 0 or
   * less for none. Default: 0
   */
    double longest_expected_time;
    /**
   * The memory that a call may take, in bytes. Surfaces that are expected to take more end with
   * WINDING_NO_MEMORY before any is allocated; 0 for no limit. Default: 0
   */
    double free_memory;
  } winding_run;

  /**
   * Fills a struct with the defaults.
   *
   * @param run the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_run_init(winding_run* run, size_t size);

  /** The types of numbers in arrays. */
  typedef enum winding_type
  {
    WINDING_FLOAT32 = 1, /**< float */
    WINDING_FLOAT64 = 2, /**< double */
    WINDING_INT32 = 3,   /**< int32_t */
    WINDING_INT64 = 4,   /**< int64_t */
    WINDING_UINT8 = 5,   /**< uint8_t */
    WINDING_UINT16 = 6   /**< uint16_t */
  } winding_type;

  /** Rows of numbers that are read. All members 0 make an array that is not there. */
  typedef struct winding_array
  {
    const void* data; /**< the first number, at an address that its type may have */
    int64_t rows;     /**< 0 or more */
    int64_t stride;   /**< numbers from the start of one row to the next, 0 for no gaps */
    int32_t type;     /**< a winding_type: floating-point for coordinates, integer for ids */
  } winding_array;

  /** The faces of a surface over its points, whose ids count from 0. */
  typedef struct winding_polygons
  {
    /** Rows of three ids; or, with offsets, rows of one: the corners of all polygons. No gaps. */
    winding_array corners;
    /** Rows of one: where each polygon begins in corners, and where the last one ends. No gaps. */
    winding_array offsets;
  } winding_polygons;

  /** How winding numbers are computed. */
  typedef enum winding_method
  {
    WINDING_METHOD_AUTO = 0,         /**< what is fastest within the tolerance */
    WINDING_METHOD_ROWS = 1,         /**< crossings of triangles along rows or rays, exact */
    WINDING_METHOD_HIERARCHICAL = 2, /**< a far field, within the tolerance */
    WINDING_METHOD_DIRECT = 3,       /**< the sum over all primitives */
    WINDING_METHOD_PARITY = 4        /**< parity of crossings, a baseline; faces only */
  } winding_method;

  /** How normals are estimated. */
  typedef enum winding_normal_estimation
  {
    WINDING_NORMAL_ESTIMATION_AUTO = 0,       /**< the tree, where its field is clear */
    WINDING_NORMAL_ESTIMATION_TREE = 1,       /**< along a spanning tree: fast */
    WINDING_NORMAL_ESTIMATION_CONSISTENT = 2, /**< w is a half at all points */
    WINDING_NORMAL_ESTIMATION_TOWARD = 3      /**< toward viewpoints; results only, see `toward` */
  } winding_normal_estimation;

  /** The choices that a field depends on, apart from its source. */
  typedef struct winding_options
  {
    uint32_t size;         /**< bytes of the struct that its caller knows */
    int32_t method;        /**< a winding_method. Default: WINDING_METHOD_AUTO */
    double tolerance;      /**< largest error of w by approximations. Default: 0.001 */
    double regularization; /**< spread of each point, 0 to 4 spacings. Default: 0 */
    double point_area;     /**< area of every point, 0 for areas by Voronoi cells. Default: 0 */
    int32_t number_of_neighbors; /**< that give areas and normals, 3 or more. Default: 20 */
    int32_t estimate_normals;    /**< whether points without normals get some. Default: 0 */
    int32_t normal_estimation;   /**< a winding_normal_estimation. Default: ..._AUTO */
    int32_t orient_faces;        /**< whether faces are turned outward first. Default: 0 */
    int32_t ignore_open_parts; /**< whether open sheets in closed parts are left out. Default: 0 */
    int32_t scattered;         /**< whether points will be asked for, not grids. Default: 0 */
    int32_t source_as_points;  /**< whether faces make a cloud of their points. Default: 0 */
    int32_t mean_point_area;   /**< whether all points get the mean of their areas. Default: 0 */
    /**
     * Where points were seen from: estimated normals look there. A position "x y z", several
     * "x y z; x y z" (each point takes the nearest), a direction "direction x y z", or one
     * of up, down, +x, -x, +y, -y, +z and -z. It is copied. Default: null, not known
     */
    const char* toward;
    /**
     * The planes of symmetry of a source that is one side of them, "y=0" or "x=0 y=0", or
     * "1 1 0 = 3" for x + y = 3. Its mirror images are added. It is copied. Default: null, none
     */
    const char* mirror;
    /**
     * The flat base of a surface that is open on one side. A direction as for `toward` puts it at
     * the end of the surface, "down 0.5" that far below, a plane as "z=-5" there. It is copied.
     * Default: null, none
     */
    const char* flat_base;
    /**
     * The side of open sheets that is inside, as "down": a direction as for `toward`. Values are
     * then w + 0.5, for a half sphere at infinity closes them. Points are one sheet, unless their
     * normals look to all sides alike. It is copied. Default: null, none
     */
    const char* sheet_side;
    /** The distance up to which points of a surface are made one, see winding_weld(). Default: 0 */
    double weld_tolerance;
    /**
     * The coordinates in which points are given, where the texts above are about space: twelve
     * numbers, the inverse of the axes by rows, then the origin. They are copied. Default: null,
     * points are given in space
     */
    const double* frame;
    /**
     * Whether winding_label() or winding_boolean() will have fields with the same options. These
     * warn of options that no field has a use for, instead of each field. Default: 0
     */
    int32_t is_one_of_several;
    /**
     * Whether normals of points only look to where each was seen from, as viewpoint minus point:
     * others are estimated that look there, unless `toward` says where. Default: 0
     */
    int32_t look_at_viewpoints;
    /**
     * Whether the field is for solids: faces that contradict each other or are there more than once
     * are turned as by orient_faces, and points without normals get some. A warning says so.
     * Options of winding_level_surface() and other functions mend the rest. Default: 0
     */
    int32_t mend_source;
  } winding_options;

  /**
   * Fills a struct with the defaults.
   *
   * @param options the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_options_init(winding_options* options, size_t size);

  /** The winding field of a source. */
  typedef struct winding_field winding_field;

  /**
   * Makes the field of a surface.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are cut into fans from their first corners
   * @param options null for the defaults; what is about points alone is not looked at
   * @param run null for the defaults
   * @param field receives the field, or null; winding_field_free() gives it back
   * @param refusal receives why the call was refused, unless it is null
   *
   * Triangles with NaN or infinite coordinates and with ids of points that are not there are left
   * out with a warning. Refused are coordinates beyond 1e100, a surface without usable faces,
   * and options out of their ranges.
   */
  WINDING_API winding_status winding_faces(winding_array points, const winding_polygons* polygons,
    const winding_options* options, const winding_run* run, winding_field** field,
    winding_refusal* refusal);

  /**
   * Makes the field of a point cloud.
   *
   * @param points three coordinates in each row
   * @param normals as many, of any length, outward; not there for estimated ones
   * @param areas one for each point; not there for Voronoi cells
   * @param options null for the defaults
   * @param run null for the defaults
   * @param field receives the field, or null; winding_field_free() gives it back
   * @param refusal receives why the call was refused, unless it is null
   *
   * Refused are points without normals, unless options have estimate_normals.
   */
  WINDING_API winding_status winding_points(winding_array points, winding_array normals,
    winding_array areas, const winding_options* options, const winding_run* run,
    winding_field** field, winding_refusal* refusal);

  /**
   * Gives a field back. Null is left alone.
   *
   * @param field the field
   */
  WINDING_API void winding_field_free(winding_field* field);

  /** Facts about a field. */
  typedef struct winding_field_info
  {
    uint32_t size;              /**< bytes of the struct that its caller knows */
    int32_t method;             /**< the winding_method that is used, never automatic */
    int32_t is_surface;         /**< whether the source has faces */
    int32_t normals_estimated;  /**< whether normals were estimated */
    int64_t primitives;         /**< triangles or points that w is the sum over */
    int64_t dropped;            /**< triangles or points that could not be used */
    int64_t boundary_edges;     /**< edges of one triangle */
    int64_t net_boundary_edges; /**< edges that do not cancel: w is an integer if there are none */
    double bounds[6];           /**< least and largest x, y and z; NaN without primitives */
    double mean_point_area;     /**< of a cloud's points; 0 for faces */
    double clear_share;         /**< of points whose estimated normals have two sides; else 0 */
    int32_t normal_estimation;  /**< the winding_normal_estimation that was used; else ..._AUTO */
    char reason[260];           /**< why the method is used, in a line */
    int32_t has_no_sides;       /**< whether faces cancel, or all normals are equal */
    int32_t is_wide_open;       /**< whether a surface is open on a side, as terrain is */
  } winding_field_info;

  /**
   * Describes a field. `info` has its size set, as by winding_field_info_init().
   *
   * @param field the field
   * @param info receives the facts; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_describe(
    const winding_field* field, winding_field_info* info, winding_refusal* refusal);
  /**
   * Fills a struct with the defaults.
   *
   * @param info the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_field_info_init(winding_field_info* info, size_t size);

  /**
   * Estimates the memory of an evaluation, the field included.
   *
   * @param field the field
   * @param samples the number of samples
   * @param with_distances whether distances are among the values
   * @param bytes receives the memory; arrays of results are left out
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_expect_memory(const winding_field* field, int64_t samples,
    int32_t with_distances, int64_t* bytes, winding_refusal* refusal);

  /**
   * Measures the source of a field, in O(n log n) time for n triangles or points.
   *
   * @param field the field
   * @param area receives the area of all triangles, or of all points, unless it is null
   * @param volume receives the volume that the source encloses, without cavities, unless it is null
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_measure(
    const winding_field* field, double* area, double* volume, winding_refusal* refusal);

  /** A grid of voxels, whose centres are the samples; x runs fastest in arrays. */
  typedef struct winding_grid
  {
    double origin[3];      /**< the first sample */
    double spacing[3];     /**< more than 0 */
    int32_t dimensions[3]; /**< samples along each axis, 1 or more */
  } winding_grid;

  /** A wish for a grid. */
  typedef struct winding_grid_request
  {
    uint32_t size;      /**< bytes of the struct that its caller knows */
    int32_t resolution; /**< cubic voxels along the longest side, 1 or more. Default: 128 */
    double voxel_size;  /**< side of the cubic voxels, 0 for resolution. Default: 0 */
    int32_t
      sampling_dimensions[3];  /**< voxels along each axis, 0 0 0 for cubic ones. Default: 0 0 0 */
    double sampling_bounds[6]; /**< least and largest x, y and z. To be set */
    double padding;            /**< margin, as a share of the longest side, or of each axis's own
                                    where voxels are not cubic; a voxel at least unless it is 0.
                                    Default: 0.05 */
    int32_t cubic; /**< whether sampling_dimensions give cubic voxels, too. Default: 0 */
  } winding_grid_request;

  /**
   * Fills a struct with the defaults.
   *
   * @param request the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_grid_request_init(winding_grid_request* request, size_t size);

  /**
   * Lays out a grid. Refused are sizes, bounds and paddings that make none.
   *
   * @param request the wish
   * @param run null for the defaults
   * @param grid the samples
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_lay_out_grid(const winding_grid_request* request,
    const winding_run* run, winding_grid* grid, winding_refusal* refusal);

  /** The rules by which winding numbers are inside. */
  typedef enum winding_inside_rule
  {
    WINDING_INSIDE_RULE_SIGNED = 0,   /**< w >= threshold */
    WINDING_INSIDE_RULE_ABSOLUTE = 1, /**< |w| >= threshold, for faces of either orientation */
    WINDING_INSIDE_RULE_ODD = 2       /**< the integer nearest to w is odd */
  } winding_inside_rule;

  /** A rule, and its threshold. A null pointer in its place stands for the defaults. */
  typedef struct winding_rule
  {
    uint32_t size;            /**< bytes of the struct that its caller knows */
    int32_t inside_rule;      /**< a winding_inside_rule. Default: WINDING_INSIDE_RULE_SIGNED */
    double winding_threshold; /**< Default: 0.5 */
  } winding_rule;

  /**
   * Fills a struct with the defaults.
   *
   * @param rule the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_rule_init(winding_rule* rule, size_t size);

  /** The rules by which voxels are inside. */
  typedef enum winding_coverage
  {
    WINDING_COVERAGE_CENTER = 0,  /**< where the centre is */
    WINDING_COVERAGE_ANY = 1,     /**< where any part is, or the source touches it */
    WINDING_COVERAGE_FRACTION = 2 /**< where half is; fills winding_values::fractions */
  } winding_coverage;

  /** The arrays that an evaluation fills, a number for each sample. Null leaves one out. */
  typedef struct winding_values
  {
    uint32_t size;    /**< bytes of the struct that its caller knows */
    int32_t type;     /**< of winding, distance: WINDING_FLOAT32 or _FLOAT64. Default: _FLOAT32 */
    void* winding;    /**< winding numbers */
    uint8_t* inside;  /**< 1 inside, 0 outside */
    void* distance;   /**< distances from the source, negative inside */
    double* gradient; /**< three numbers for each sample, in 1/length; for points only */
    float* fractions; /**< shares of voxels that are inside; for WINDING_COVERAGE_FRACTION */
    double distance_limit;    /**< largest distance that is written, 0 for any. Default: 0 */
    int32_t coverage;         /**< a winding_coverage, for grids. Default: ..._CENTER */
    int32_t coverage_samples; /**< along each axis, for fractions, 1 to 10. Default: 4 */
    int64_t inside_count;     /**< receives the number of samples inside */
    int32_t without_advice;   /**< whether nothing is said about the grid. Default: 0 */
    /** For fractions: (coverage_samples³ + 63) / 64 words for each voxel, with a bit for each
     * sample. A call sets the bits of samples inside, and fractions count all bits that are set:
     * what several fields cover of a voxel, evaluated one by one from words of 0 on. Inside, and
     * inside_count, are what has at least half. Null, the default, counts this field alone. */
    uint64_t* united;
    /** Whether faces or normals that look inward are turned first, and open sheets are inside as a
     * plate of three voxels, which changes inside and fractions. A warning says so. Default: 0 */
    int32_t mend_source;
  } winding_values;

  /**
   * Fills a struct with the defaults.
   *
   * @param values the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_values_init(winding_values* values, size_t size);

  /**
   * Finds the number of cubic voxels along the longest side of a grid that the walls of a surface
   * ask for: 128, or up to 286 where they are thinner than one and a half voxels. Of several solids
   * on one grid, the largest number counts. It takes no longer than what warns of thin walls.
   *
   * @param field the field
   * @param request the wish, whose resolution does not count
   * @param rule null for the defaults
   * @param mend_source whether the solid is made of a mended source
   * @param run null for the defaults
   * @param resolution receives the number
   * @param reason receives why it is not 128, "" where it is; null where nobody asks
   * @param reason_size bytes that reason has
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_wall_resolution(const winding_field* field,
    const winding_grid_request* request, const winding_rule* rule, int32_t mend_source,
    const winding_run* run, int32_t* resolution, char* reason, size_t reason_size,
    winding_refusal* refusal);

  /**
   * Evaluates a field at the samples of a grid.
   *
   * @param field the field
   * @param grid the samples
   * @param extent first and last index along x, y and z of the part to evaluate; null for all
   * @param rule what is inside; null for the defaults
   * @param values the arrays, with as many numbers as the extent has samples
   * @param run null for the defaults
   * @param refusal receives why the call was refused, unless it is null
   *
   * Warns, for the whole grid only, where the source looks inward, the grid misses it or is too
   * coarse for it, or nothing is inside.
   */
  WINDING_API winding_status winding_evaluate_grid(const winding_field* field,
    const winding_grid* grid, const int32_t* extent, const winding_rule* rule,
    winding_values* values, const winding_run* run, winding_refusal* refusal);

  /**
   * Evaluates a field at points. Values at points that are NaN or infinite are NaN, and 0 inside.
   *
   * @param field the field
   * @param points three coordinates in each row
   * @param rule the rule for what is inside; null for the defaults
   * @param values the arrays
   * @param run null for the defaults
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_evaluate_points(const winding_field* field,
    winding_array points, const winding_rule* rule, winding_values* values, const winding_run* run,
    winding_refusal* refusal);

  /** The cells of a mesh over its points, whose ids count from 0, as VTK has them. */
  typedef struct winding_cells
  {
    /**
     * Rows of one WINDING_UINT8 with VTK's numbers: 10 tetrahedron, 11 voxel, 12 hexahedron,
     * 13 wedge, 14 pyramid, 15 and 16 prisms of five and six sides, 42 polyhedron, and others up to
     * Lagrange and Bézier cells. Surfaces, lines and points have no volume. No gaps.
     */
    winding_array types;
    /**
     * Rows of one: the ids of all cells, in VTK's order. A polyhedron has the number of its faces,
     * then of each face the number of its points and their ids. No gaps.
     */
    winding_array corners;
    /** Rows of one: where each cell begins in corners, and where the last one ends. No gaps. */
    winding_array offsets;
  } winding_cells;

  /**
   * Finds the share of each cell of a mesh that is inside: exact for closed surfaces, so that
   * shares times volumes add up to the volume of what is inside.
   *
   * @param field the field
   * @param points three coordinates in each row
   * @param cells the cells. Faces that are not planar count as triangles around the mean of their
   *   corners
   * @param rule what is inside; null for the defaults
   * @param fractions receives a number of 0 to 1 for each cell: 1 or 0 for a cell without volume,
   *   as its middle is inside or not, and NaN where a point is not finite, there is none, or the
   *   faces do not close
   * @param run null for the defaults
   * @param refusal receives why the call was refused, unless it is null
   *
   * Warns of curved cells, which count as straight between their corners, of cells without volume,
   * of polyhedra with a face that is missing or turned, and of cells that are not finite. Refuses
   * cells with too few points, ids of points that do not exist, and unknown types.
   */
  WINDING_API winding_status winding_cell_fractions(const winding_field* field,
    winding_array points, const winding_cells* cells, const winding_rule* rule, float* fractions,
    const winding_run* run, winding_refusal* refusal);

  /**
   * Writes a sentence that front ends say of data sets.
   *
   * @param sentence its name in Sentences.def
   * @param values texts in place of {0}, {1} and so on
   * @param count how many there are
   * @param run whose words it is to have; null for the defaults
   * @param text receives the line, cut off where it is longer
   * @param size bytes that text has
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_sentence(const char* sentence, const char* const* values,
    size_t count, const winding_run* run, char* text, size_t size, winding_refusal* refusal);

  /** Counts of cells whose part in a source may differ from what their owner expects. */
  typedef struct winding_cell_counts
  {
    uint32_t size;    /**< bytes of the struct that its caller knows */
    int64_t turned;   /**< cells with volume at the outer surface, ordered the other way round */
    int64_t left_out; /**< cells of two dimensions where there are three, or the latter */
    int64_t loose;    /**< lines and single points, where there are faces or cells with volume */
    int64_t flat;     /**< cells with curved faces that no division brings near their shape */
  } winding_cell_counts;

  /**
   * Fills a struct with the defaults.
   *
   * @param counts the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_cell_counts_init(winding_cell_counts* counts, size_t size);

  /**
   * Returns the dimension of cells of one of VTK's types, 0 to 3, or -1 for a type that VTK has no
   * cells of.
   *
   * @param type the type
   * @param is_curved receives 1 if the cells have edges that need not be straight lines, and 0 if
   *   not, unless it is null
   */
  WINDING_API int32_t winding_cell_dimension(int32_t type, int32_t* is_curved);

  /**
   * Refuses cells that contradict themselves, before code follows them.
   *
   * @param cells the cells; without types, as in polydata, only their ids are checked
   * @param faces by cell, the faces of polyhedra as corners have them; the corners of polyhedra are
   *   then their points, as VTK has them. Null for faces in the corners
   * @param degrees rows of three, by cell: the degrees of Lagrange and Bézier cells along their
   *   axes; no rows for equal ones
   * @param count how many cells there are to be
   * @param points how many points there are
   * @param first the number that messages have for the first cell
   * @param name what messages call the data, as in "the source"
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_check_cells(const winding_cells* cells,
    const winding_cells* faces, winding_array degrees, int64_t count, int64_t points, int64_t first,
    const char* name, winding_refusal* refusal);

  /**
   * Says which cells make the surface of a mesh. Where there are cells of two and of three
   * dimensions, one kind is left out.
   *
   * @param types rows of one WINDING_UINT8
   * @param ghosts VTK's ghost flags of the cells, which make no surface; null for none
   * @param surface_cells 1 to take cells of two dimensions, 0 for cells of three
   * @param are_own receives 1 for each cell that is taken, and 0 for the others
   * @param counts receives, added up, cells of the other kind and loose ones
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_choose_cells(winding_array types, const uint8_t* ghosts,
    int32_t surface_cells, uint8_t* are_own, winding_cell_counts* counts, winding_refusal* refusal);

  /** The outer surface of a mesh, as VTK's vtkDataSetSurfaceFilter extracts it. */
  typedef struct winding_skin
  {
    winding_array points;      /**< three coordinates in each row */
    winding_polygons polygons; /**< over these points, with offsets */
    winding_array owners;      /**< rows of one: by polygon, its cell in the mesh */
    /**
     * Rows of one: by point, the mesh's point that it is. New points on curved faces may have any
     * number. Without rows straight cells are taken as convex.
     */
    winding_array origins;
  } winding_skin;

  /**
   * Says how often to halve the edges of curved faces, at most 5 times: until they are within a
   * thousandth of the mesh's diagonal of their shape.
   *
   * @param once the skin with all curved edges halved once (SetNonlinearSubdivisionLevel(1))
   * @param twice the skin with all curved edges halved twice
   * @param cells how many cells the mesh has
   * @param diagonal the diagonal of the mesh's box
   * @param halvings receives the number
   * @param counts receives, added up, cells that stay too far from their shape
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_halvings(const winding_skin* once, const winding_skin* twice,
    int64_t cells, double diagonal, int32_t* halvings, winding_cell_counts* counts,
    winding_refusal* refusal);

  /**
   * Turns the polygons of a skin away from their own cells, and leaves out seams: polygons with
   * corners at the same places in opposite senses, between cells that share no points.
   *
   * @param points the mesh's, three coordinates in each row
   * @param cells the mesh's; those that own no polygon may be empty
   * @param skin the polygons
   * @param corners receives the corners of the polygons that are kept: room for all
   * @param offsets receives where each of these begins, and where the last one ends
   * @param polygons receives their numbers in the skin
   * @param kept receives how many there are
   * @param counts receives, added up, cells that are turned
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_outward_polygons(winding_array points,
    const winding_cells* cells, const winding_skin* skin, int64_t* corners, int64_t* offsets,
    int64_t* polygons, int64_t* kept, winding_cell_counts* counts, winding_refusal* refusal);

  /**
   * Warns of cells that were counted: left out, loose, or flat.
   *
   * @param counts the counts
   * @param run what takes the warnings
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_warn_of_cells(
    const winding_cell_counts* counts, const winding_run* run, winding_refusal* refusal);

  /** The differences of values from the sum over all primitives, which is slow and exact. */
  typedef struct winding_verification
  {
    uint32_t size;         /**< bytes of the struct that its caller knows */
    int64_t samples;       /**< of the whole grid that were compared */
    double max_error;      /**< over these */
    double rms_error;      /**< over these */
    int64_t near_source;   /**< samples within two voxels of the source that were compared */
    double near_max_error; /**< over these */
  } winding_verification;

  /**
   * Fills a struct with the defaults.
   *
   * @param verification the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_verification_init(winding_verification* verification, size_t size);

  /**
   * Verifies winding numbers on a grid at samples that are drawn, the same ones for any extent.
   *
   * @param field the field
   * @param grid the samples
   * @param extent the part that there are values of, as for winding_evaluate_grid(); null for all
   * @param winding the winding numbers, rows of one
   * @param samples to draw from the grid, and as many from within two voxels of the source
   * @param run null for the defaults
   * @param verification receives the differences; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_verify(const winding_field* field, const winding_grid* grid,
    const int32_t* extent, winding_array winding, int64_t samples, const winding_run* run,
    winding_verification* verification, winding_refusal* refusal);

  /** Faces that the library has made or read. */
  typedef struct winding_mesh winding_mesh;

  /** The origins of the distances of an offset or a shell. */
  typedef enum winding_distances_from
  {
    WINDING_DISTANCES_FROM_NOTHING = 0, /**< there is no offset and no shell */
    WINDING_DISTANCES_FROM_SOURCE = 1,
    WINDING_DISTANCES_FROM_SURFACE = 2 /**< the surface of the solid */
  } winding_distances_from;

  /** The arrays of a mesh, which belong to it. Those that it does not have are null. */
  typedef struct winding_mesh_arrays
  {
    uint32_t size;                    /**< bytes of the struct that its caller knows */
    int32_t type;                     /**< of points: WINDING_FLOAT32 or _FLOAT64 */
    int64_t point_count;              /**< rows of points */
    int64_t polygon_count;            /**< 0 for points alone */
    int64_t corner_count;             /**< of all polygons */
    const void* points;               /**< three coordinates each */
    const int64_t* offsets;           /**< polygon_count + 1 */
    const int64_t* corners;           /**< ids of points */
    const void* point_normals;        /**< three each */
    int32_t normals_type;             /**< of point_normals */
    const float* polygon_normals;     /**< three each, of unit length or 0 */
    const double* point_areas;        /**< one each */
    const uint16_t* labels;           /**< two for each polygon: behind it, and before it */
    const int64_t* numbers;           /**< one for each polygon, which winding_faults() and
                                           winding_boolean() explain */
    int64_t column_count;             /**< of winding_read_table() and winding_read_columns() */
    int64_t line_count;               /**< of a file */
    const int64_t* line_offsets;      /**< line_count + 1 */
    const int64_t* line_corners;      /**< ids of points */
    int64_t vertex_count;             /**< cells of one point or more, of a file */
    const int64_t* vertex_offsets;    /**< vertex_count + 1 */
    const int64_t* vertex_corners;    /**< ids of points */
    const uint8_t* colors;            /**< color_components for each point */
    int32_t color_components;         /**< 3, or 4 with opacity */
    const float* texture_coordinates; /**< two for each point */
    int64_t regions_count;            /**< of winding_mesh_regions() */
    const double* slit_widths;        /**< one for each polygon, of WINDING_FAULT_BOUNDARY */
    int32_t distances_from;           /**< a winding_distances_from, of a surface that moved */
    int64_t filled_cavities;          /**< of winding_level_surface() */
    int64_t sample_count;             /**< of inside */
    const uint8_t* inside;            /**< one for each sample, of a surface with an image */
    int32_t is_closed;                /**< whether a surface of a grid is */
    int64_t part_count;               /**< of that surface: connected sets of samples inside */
    double volume;                    /**< that it encloses; NaN of an open one, and of others */
    double input_volume;              /**< of winding_level_surface(): the integral of w; NaN of an
                                           open source, and of others */
    const char* solid_in_words;       /**< the four numbers before for people, of a surface of a
                                           grid; null of others */
  } winding_mesh_arrays;

  /**
   * Fills a struct with the defaults.
   *
   * @param arrays the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_mesh_arrays_init(winding_mesh_arrays* arrays, size_t size);

  /**
   * Shows the arrays of a mesh. They live until winding_mesh_free().
   *
   * @param mesh the mesh
   * @param arrays receives the pointers; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_mesh_show(
    const winding_mesh* mesh, winding_mesh_arrays* arrays, winding_refusal* refusal);

  /**
   * Gives a mesh back. Null is left alone.
   *
   * @param mesh the mesh
   */
  WINDING_API void winding_mesh_free(winding_mesh* mesh);

  /** The fates of a source's edges and corners. */
  typedef enum winding_features
  {
    WINDING_FEATURES_SMOOTH = 0, /**< they are rounded within a voxel */
    WINDING_FEATURES_SHARP = 1,  /**< they are kept, by faces of four corners */
    WINDING_FEATURES_VOXELS = 2  /**< the surface has the sides of the voxels around the samples */
  } winding_features;

  /** The sides of a solid's surface that its shell lies on. */
  typedef enum winding_shell_side
  {
    WINDING_SHELL_SIDE_INWARD = 0,
    WINDING_SHELL_SIDE_OUTWARD = 1,
    /** Half of the thickness on either side; an open source is thickened as a sheet, with its rim,
     * unless cavities are filled or the surface moves. */
    WINDING_SHELL_SIDE_CENTERED = 2
  } winding_shell_side;

  /**
   * How the surface between inside and outside is made. Cavities are filled, the surface moves by
   * an offset, and a shell replaces the solid, in this order. Distances are measured from the
   * source where all of its triangles bound the solid, and else from the surface of the solid on
   * this grid, or on a finer one where this grid reaches far beyond the source.
   */
  typedef struct winding_surface_options
  {
    uint32_t size;              /**< bytes of the struct that its caller knows */
    int32_t features;           /**< a winding_features. Default: WINDING_FEATURES_SMOOTH */
    int32_t generate_triangles; /**< whether quads of sharp surfaces are cut. Default: 0 */
    int32_t close_border;     /**< whether what is beyond the grid counts as outside. Default: 0 */
    int32_t generate_normals; /**< whether normals are made. Default: 1 */
    int32_t type; /**< of points: _FLOAT32, _FLOAT64, or 0 for what they need. Default: 0 */
    int32_t fill_cavities; /**< whether what the outside does not reach is inside. Default: 0 */
    int32_t shell_side;    /**< a winding_shell_side. Default: WINDING_SHELL_SIDE_INWARD */
    double offset; /**< length by which the surface moves outward, negative: inward. Default: 0 */
    double shell;  /**< thickness of the shell that replaces the solid; 0 for none. Default: 0 */
    /** openings as wide as that do not let the outside into cavities; used with fill_cavities.
        Default: 0 */
    double gap_width;
    int32_t generate_image; /**< whether the mesh shows which samples are inside. Default: 0 */
    const char* const*
      names; /**< of the fields of winding_boolean(), for warnings. Default: null */
    /** Whether faces or normals are turned that look inward or contradict each other, open sheets
        become plates of three voxels, and the surface is closed at the border of the grid. A
        warning says what was done. Default: 1 */
    int32_t mend_source;
  } winding_surface_options;

  /**
   * Fills a struct with the defaults.
   *
   * @param options the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_surface_options_init(winding_surface_options* options, size_t size);

  /**
   * Makes the surface between inside and outside of a field: its vertices lie on the edges of
   * a grid, exactly where w crosses the threshold. It is closed, except at the border of the grid,
   * and 2-manifold.
   *
   * @param field the field
   * @param grid the samples
   * @param rule the rule for what is inside; null for the defaults
   * @param options null for the defaults
   * @param run null for the defaults
   * @param mesh receives the surface, or null; winding_mesh_free() gives it back
   * @param refusal receives why the call was refused, unless it is null
   *
   * Warns as winding_evaluate_grid() does.
   */
  WINDING_API winding_status winding_level_surface(const winding_field* field,
    const winding_grid* grid, const winding_rule* rule, const winding_surface_options* options,
    const winding_run* run, winding_mesh** mesh, winding_refusal* refusal);

  /**
   * Estimates the memory of a surface that winding_level_surface() makes, and of the work on it.
   *
   * @param field the field
   * @param grid the samples
   * @param rule the rule for what is inside; null for the defaults
   * @param options null for the defaults
   * @param run null for the defaults
   * @param bytes receives the memory
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_expect_surface(const winding_field* field,
    const winding_grid* grid, const winding_rule* rule, const winding_surface_options* options,
    const winding_run* run, double* bytes, winding_refusal* refusal);

  /** The operations on several solids. */
  typedef enum winding_operation
  {
    WINDING_OPERATION_UNION = 0,        /**< what is inside of any */
    WINDING_OPERATION_INTERSECTION = 1, /**< what is inside of all */
    WINDING_OPERATION_DIFFERENCE = 2,   /**< what is inside of the first, and of no other */
    WINDING_OPERATION_XOR = 3           /**< what is inside of an odd number */
  } winding_operation;

  /**
   * Makes the surface of the result of an operation on solids, which fields enclose. Its vertices
   * lie on the edges of a grid, exactly where the solid ends whose side decides there. It is
   * closed, except at the border of the grid, and 2-manifold. The array `numbers` of the mesh has
   * the number of the field that each polygon lies on, from 0 on.
   *
   * @param fields one for each solid
   * @param count of solids, 2 or more
   * @param operation a winding_operation
   * @param grid the samples
   * @param rules the rule for what is inside of each, all with the size of the first; null for the
   *   defaults
   * @param options null for the defaults; offset, shell and fill_cavities are 0
   * @param run null for the defaults
   * @param mesh receives the surface, or null; winding_mesh_free() gives it back
   * @param refusal receives why the call was refused, unless it is null
   *
   * Warns of fields as winding_evaluate_grid() does, but of the grid only where no sample is inside
   * of one of them, of an empty result, and of one that is open at the border of the grid.
   */
  WINDING_API winding_status winding_boolean(const winding_field* const* fields, size_t count,
    int32_t operation, const winding_grid* grid, const winding_rule* rules,
    const winding_surface_options* options, const winding_run* run, winding_mesh** mesh,
    winding_refusal* refusal);

  /**
   * Makes the faces of voxels, as quads, between labels that differ.
   *
   * @param voxels one integer for each sample, WINDING_UINT8 or WINDING_UINT16, 0 outside
   * @param grid the samples
   * @param run null for the defaults
   * @param mesh receives the faces with labels, or null
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_voxel_surface(winding_array voxels, const winding_grid* grid,
    const winding_run* run, winding_mesh** mesh, winding_refusal* refusal);

  /** The solids that give a voxel its label, if it is in several. */
  typedef enum winding_overlap_rule
  {
    WINDING_OVERLAP_RULE_FIRST = 0,   /**< the first one */
    WINDING_OVERLAP_RULE_LAST = 1,    /**< the last one */
    WINDING_OVERLAP_RULE_LARGEST = 2, /**< the one with the largest w */
    WINDING_OVERLAP_RULE_SMALLEST = 3 /**< the one with the smallest volume */
  } winding_overlap_rule;

  /** The way in which solids become labels. */
  typedef struct winding_label_options
  {
    uint32_t size;            /**< bytes of the struct that its caller knows */
    int32_t overlap_rule;     /**< a winding_overlap_rule. Default: ..._FIRST */
    int32_t coverage;         /**< a winding_coverage. Default: ..._CENTER */
    int32_t coverage_samples; /**< along each axis, for fractions, 1 to 10. Default: 4 */
    int32_t have_one_unit;    /**< whether solids surely have one unit, as parts of a mesh have:
                                   there is no warning of others then. Default: 0 */
    int32_t mend_source;      /**< whether each solid is mended, as surfaces are. Default: 1 */
  } winding_label_options;

  /**
   * Fills a struct with the defaults.
   *
   * @param options the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_label_options_init(winding_label_options* options, size_t size);

  /**
   * The arrays of labels, a number for each sample. Null leaves one out. Shares say how much of
   * a voxel is inside, and are for WINDING_COVERAGE_FRACTION only.
   */
  typedef struct winding_labels
  {
    uint32_t size;            /**< bytes of the struct that its caller knows */
    uint16_t* labels;         /**< 0 for none; may not be left out */
    uint16_t* counts;         /**< the number of solids that each sample is in */
    uint16_t* first_labels;   /**< the labels with the largest shares; all four, or none */
    float* first_shares;      /**< these shares */
    uint16_t* second_labels;  /**< the labels with the next shares, 0 for none */
    float* second_shares;     /**< these shares */
    float* const* shares;     /**< an array for the shares of each solid */
    const char* const* names; /**< of the solids, for warnings; null for labels in their place */
    const uint8_t* are_open;  /**< 1 for a solid that needs no voxel, as an open part inside of
                                 others (winding_open_parts()); null for none */
  } winding_labels;

  /**
   * Fills a struct with the defaults.
   *
   * @param labels the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_labels_init(winding_labels* labels, size_t size);

  /**
   * Labels the voxels of a grid by the solids that they are in.
   *
   * @param fields one for each solid
   * @param numbers the label of each, 1 to 65535; null for 1, 2, ...
   * @param count of solids, at most 65535
   * @param grid the samples
   * @param extent first and last index along x, y and z of the part to evaluate; null for all
   * @param rule the rule for what is inside; null for the defaults
   * @param options null for the defaults
   * @param labels the arrays, with as many numbers as the extent has samples
   * @param run null for the defaults
   * @param refusal receives why the call was refused, unless it is null
   *
   * Warns of solids that are empty, have holes or seem to be in another unit than another one, as
   * inches are next to millimetres, and for the whole grid of solids without a label, as a whole or
   * in part.
   */
  WINDING_API winding_status winding_label(const winding_field* const* fields,
    const uint16_t* numbers, size_t count, const winding_grid* grid, const int32_t* extent,
    const winding_rule* rule, const winding_label_options* options, const winding_labels* labels,
    const winding_run* run, winding_refusal* refusal);

  /**
   * Finds the solids of a surface by its connectivity, with their cavities. Solids are numbered by
   * their volumes, the largest first.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners
   * @param run null for the defaults
   * @param solids receives a number from 0 on for each polygon, and -1 for unusable ones
   * @param count receives the number of solids
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_solids(winding_array points, const winding_polygons* polygons,
    const winding_run* run, int32_t* solids, int64_t* count, winding_refusal* refusal);

  /**
   * Finds the open parts of a surface that lie inside of its closed parts, as baffles do.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners
   * @param run null for the defaults
   * @param are_open receives 1 for each polygon of these parts, and 0 for any other
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_open_parts(winding_array points,
    const winding_polygons* polygons, const winding_run* run, uint8_t* are_open,
    winding_refusal* refusal);

  /**
   * Finds the places of faces or points that are nearest to samples, so that samples take over what
   * these have there: the data of `corners`, each times its weight, or the data of the polygon. The
   * first one counts where several are equally near, up to rounding.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners; null
   * for points alone
   * @param options null for the defaults; mirror and weld_tolerance count, with which samples are
   * near to images of the faces or points, and to points that are made one
   * @param samples three coordinates in each row
   * @param nearest receives the polygon or point that is nearest to each sample; -1 for samples
   * that are NaN or infinite, and where there is nothing
   * @param corners receives three ids of points for each sample, the corners of a triangle of the
   * polygon, or the point three times; -1 for none. May be null
   * @param weights receives their weights at the nearest place, 0 or more, with sum 1; NaN for
   * none. May be null, which takes much less time for samples far from the faces
   * @param run null for the defaults
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_nearest(winding_array points, const winding_polygons* polygons,
    const winding_options* options, winding_array samples, int64_t* nearest, int64_t* corners,
    double* weights, const winding_run* run, winding_refusal* refusal);

  /** The health of a surface. */
  typedef struct winding_report
  {
    uint32_t size;                 /**< bytes of the struct that its caller knows */
    int32_t closed;                /**< whether all edges cancel, and there are triangles */
    int64_t triangles;             /**< that polygons are cut into */
    int64_t vertices;              /**< rows of points */
    int64_t vertices_merged;       /**< finite positions, equal ones counted once */
    int64_t edges;                 /**< between different positions */
    int64_t boundary_edges;        /**< of one triangle */
    int64_t boundary_loops;        /**< connected pieces of the boundary edges */
    int64_t nonmanifold_edges;     /**< of more than two triangles */
    int64_t inconsistent_edges;    /**< that two triangles run along in the same sense */
    int64_t net_boundary_edges;    /**< that do not cancel */
    int64_t components_vertex;     /**< pieces connected through vertices */
    int64_t components_edge;       /**< pieces connected through edges */
    int64_t closed_components;     /**< pieces whose edges cancel */
    int64_t inverted_components;   /**< that look inward, and are no cavities */
    int64_t nested_solids;         /**< that look outward inside of others */
    int64_t one_sided_components;  /**< that no turning could make agree */
    int64_t open_parts_inside;     /**< open sheets inside of closed parts */
    int64_t duplicate_faces;       /**< triangles of faces that are there before */
    int64_t degenerate;            /**< triangles with less than three different vertices */
    int64_t zero_area;             /**< triangles with three different vertices on a line */
    int64_t unreferenced_vertices; /**< different positions that no triangle uses */
    int64_t euler;                 /**< vertices less edges plus triangles: 2 for a sphere */
    double volume;                 /**< signed; for closed surfaces */
    double area;                   /**< of all triangles except repeated ones */
    double fractional_share;       /**< samples where w is no integer; NaN without a grid */
    double bbox[6];                /**< least x, y and z, then the largest; NaN without triangles */
    int64_t non_finite;  /**< triangles left out for coordinates that are NaN or infinite */
    int64_t invalid_ids; /**< triangles left out for ids of points that are not there */
    double widest_slit;  /**< largest width along boundary edges; NaN without any */
  } winding_report;

  /**
   * Fills a struct with the defaults.
   *
   * @param report the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_report_init(winding_report* report, size_t size);

  /**
   * Moves points onto others that are no farther away than a tolerance, so that slits between faces
   * close. The result depends on neither the order of the points nor on threads. Points with NaN or
   * infinite coordinates stay.
   *
   * @param points three coordinates in each row
   * @param tolerance in the unit of the points, 0 or more; 0 moves none
   * @param run null for the defaults
   * @param welded receives three numbers for each point
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_weld(winding_array points, double tolerance,
    const winding_run* run, double* welded, winding_refusal* refusal);

  /**
   * Adds to a surface what options say that it lacks: points are welded, and triangles get their
   * mirror images and walls with a flat base.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are cut into fans from their first corners
   * @param options `mirror`, `flat_base` and `weld_tolerance` are looked at; null for the defaults
   * @param run null for the defaults
   * @param mesh receives the triangles, or null; winding_mesh_free() gives it back
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_complete(winding_array points,
    const winding_polygons* polygons, const winding_options* options, const winding_run* run,
    winding_mesh** mesh, winding_refusal* refusal);

  /**
   * Finds the bounds of a source once it has what options say that it lacks: grids lie around them.
   *
   * @param options `mirror` and `flat_base` are looked at; null for the defaults
   * @param bounds the bounds of the source as it is, least and largest x, then y, then z; receives
   *   the bounds of the completed source. Empty ones, with a least beyond their largest, stay so
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_complete_bounds(
    const winding_options* options, double* bounds, winding_refusal* refusal);

  /**
   * Examines a surface. Advice comes as warnings, the most important first.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners
   * @param run null for the defaults
   * @param report receives the counts; its size is set
   * @param refusal receives why the call was refused, unless it is null
   *
   * The width of a boundary edge is the distance of its ends and its middle, the largest of the
   * three, from the nearest boundary edge that runs the opposite way. That is about the width of a
   * hole, and the distance of the two sides of a slit.
   */
  WINDING_API winding_status winding_examine(winding_array points, const winding_polygons* polygons,
    const winding_run* run, winding_report* report, winding_refusal* refusal);

  /** The faults of edges. */
  typedef enum winding_fault
  {
    WINDING_FAULT_BOUNDARY = 0,     /**< edges that do not cancel, as loops */
    WINDING_FAULT_CAPS = 1,         /**< the triangles that close these loops */
    WINDING_FAULT_NON_MANIFOLD = 2, /**< edges of more than two triangles */
    WINDING_FAULT_INCONSISTENT = 3  /**< edges that two triangles run along in the same sense */
  } winding_fault;

  /**
   * Finds what is wrong with the edges of a surface.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners
   * @param fault a winding_fault
   * @param run null for the defaults
   * @param mesh receives loops as polygons whose last corner is the first one, caps as triangles,
   *   or edges as polygons of two corners, over the points that they use. Its numbers are how often
   *   a loop runs along an edge, at most; the loop of each triangle of a cap, from 0 on; the
   *   triangles at an edge; or 2. The slit widths of loops are the largest of their boundary edges,
   *   NaN without any.
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_faults(winding_array points, const winding_polygons* polygons,
    int32_t fault, const winding_run* run, winding_mesh** mesh, winding_refusal* refusal);

  /** The health of a point cloud. Figures that cannot be had are NaN. */
  typedef struct winding_cloud_report
  {
    uint32_t size;             /**< bytes of the struct that its caller knows */
    int32_t normals;           /**< whether there are normals */
    int64_t points;            /**< rows of points */
    int64_t duplicates;        /**< points beyond the first at their place */
    int64_t zero_normals;      /**< normals of length 0 */
    int64_t non_unit_normals;  /**< normals whose length is neither 0 nor 1 */
    int64_t non_finite;        /**< points with NaN or infinite numbers; the rest leaves them out */
    double spacing_min;        /**< least distance of a place to the nearest other one */
    double spacing_median;     /**< of these distances */
    double spacing_mean;       /**< of these distances */
    double spacing_max;        /**< of these distances */
    double opposite_neighbors; /**< share of neighbours with opposite normals */
    double w_behind;           /**< median of w behind the points */
    double w_before;           /**< median of w before the points */
    double outward_share;      /**< of points with w about 1 behind and 0 before them */
    double inward_share;       /**< of points with w about 0 behind and -1 before them */
    double bbox[6];            /**< least x, y and z, then the largest */
  } winding_cloud_report;

  /**
   * Fills a struct with the defaults.
   *
   * @param report the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_cloud_report_init(winding_cloud_report* report, size_t size);

  /**
   * Examines a point cloud. Advice comes as warnings, the most important first.
   *
   * @param points three coordinates in each row
   * @param normals as many, of any length; not there for points alone
   * @param run null for the defaults
   * @param report receives the figures; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_examine_points(winding_array points, winding_array normals,
    const winding_run* run, winding_cloud_report* report, winding_refusal* refusal);

  /**
   * Finds the polygons to turn round, and to leave out, so that a surface has an outside.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners
   * @param run null for the defaults
   * @param turned receives 1 for each polygon to turn, and 0 for any other
   * @param left_out receives 1 for each polygon to leave out, since it is there twice
   * @param triangles receives the number of triangles to turn, unless it is null
   * @param components receives the number of connected parts to turn, unless it is null
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_orient(winding_array points, const winding_polygons* polygons,
    const winding_run* run, uint8_t* turned, uint8_t* left_out, int64_t* triangles,
    int64_t* components, winding_refusal* refusal);

  /** How normals were estimated, and what their own field says of them. */
  typedef struct winding_estimate
  {
    uint32_t size;             /**< bytes of the struct that its caller knows */
    int32_t normal_estimation; /**< a winding_normal_estimation, never automatic */
    double clear_share;        /**< of points with w of about 1 behind and 0 before them */
  } winding_estimate;

  /**
   * Fills a struct with the defaults.
   *
   * @param estimate the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_estimate_init(winding_estimate* estimate, size_t size);

  /**
   * Estimates outward normals of points, and the areas that they stand for.
   *
   * @param points three coordinates in each row
   * @param options null for the defaults; the choices about areas and normals count
   * @param run null for the defaults
   * @param normals receives three numbers for each point, of unit length; 0 for unusable points. It
   *   holds viewpoint minus point where `look_at_viewpoints` is set
   * @param areas receives a number for each point, unless it is null; NaN for unusable points
   * @param estimate receives how, unless it is null; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_estimate_normals(winding_array points,
    const winding_options* options, const winding_run* run, float* normals, double* areas,
    winding_estimate* estimate, winding_refusal* refusal);

  /**
   * Finds what the points of a mesh are as a cloud.
   *
   * @param points three coordinates in each row
   * @param polygons triangles, or polygons, which are taken as fans from their first corners
   * @param run null for the defaults
   * @param normals receives three numbers for each point, the sum of the area vectors of its
   *   triangles
   * @param areas receives a third of the areas of its triangles for each point
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_vertices(winding_array points,
    const winding_polygons* polygons, const winding_run* run, double* normals, double* areas,
    winding_refusal* refusal);

  /**
   * Finds the normals to turn round, so that they point outward. Their directions stay.
   *
   * @param points three coordinates in each row
   * @param normals three numbers for each point, of any length
   * @param run null for the defaults
   * @param turned receives 1 for each normal to turn, and 0 for any other and for unusable points
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_orient_normals(winding_array points, winding_array normals,
    const winding_run* run, uint8_t* turned, winding_refusal* refusal);

  /**
   * Finds the areas that points with normals stand for: their Voronoi cells.
   *
   * @param points three coordinates in each row
   * @param normals three numbers for each point, of any length
   * @param options null for the defaults
   * @param run null for the defaults
   * @param areas receives a number for each point; NaN for unusable points
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_point_areas(winding_array points, winding_array normals,
    const winding_options* options, const winding_run* run, double* areas,
    winding_refusal* refusal);

  /**
   * Reads a file: .obj, .off, .ply, .stl, .xyz, .pwn, .csv or .tsv by its name.
   *
   * @param path in UTF-8
   * @param run null for the defaults
   * @param mesh receives points, polygons where there are any, and normals and areas of points
   * @param refusal receives why the call was refused, unless it is null
   *
   * Columns without a meaning are left out; winding_read_table() has them. Warns of content that
   * cannot be read.
   */
  WINDING_API winding_status winding_read(
    const char* path, const winding_run* run, winding_mesh** mesh, winding_refusal* refusal);

  /**
   * Reads points as winding_read() does, from chosen columns: .csv, .tsv, .xyz or .pwn by its name.
   *
   * @param path in UTF-8
   * @param columns as "x=Easting y=Northing z=Height nx=4 ny=5 nz=6 area=7", by names or by
   * numbers from 1 on; what is left out goes by usual names
   * @param run null for the defaults
   * @param mesh receives points, normals and areas where there are any, and all other columns
   * @param refusal receives why the call was refused, unless it is null
   *
   * Where x, y and z are numbers, and the first row has numbers in their columns, the file has no
   * row of names.
   */
  WINDING_API winding_status winding_read_columns(const char* path, const char* columns,
    const winding_run* run, winding_mesh** mesh, winding_refusal* refusal);

  /**
   * Reads a file as winding_read() does, with all other columns: of a table (.csv, .tsv) with a row
   * of names, of points with names (.xyz, .pwn), and single numbers of the vertices of .ply.
   *
   * @param path in UTF-8
   * @param normals_and_areas whether columns of a table with these names become normals and areas
   * @param run null for the defaults
   * @param mesh receives what winding_read() gives, and columns
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_read_table(const char* path, int32_t normals_and_areas,
    const winding_run* run, winding_mesh** mesh, winding_refusal* refusal);

  /** A column of points, which belongs to its mesh. */
  typedef struct winding_column
  {
    uint32_t size;            /**< bytes of the struct that its caller knows */
    const char* name;         /**< in UTF-8 */
    const double* numbers;    /**< one for each point; null for texts */
    const char* const* texts; /**< one for each point; null for numbers */
  } winding_column;

  /**
   * Fills a struct with the defaults.
   *
   * @param column the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_column_init(winding_column* column, size_t size);

  /**
   * Shows a column of a mesh. It lives until winding_mesh_free().
   *
   * @param mesh the mesh
   * @param index from 0 on
   * @param column receives the pointers; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_mesh_column(
    const winding_mesh* mesh, int64_t index, winding_column* column, winding_refusal* refusal);

  /** Regions of one kind that a file names, which belong to their mesh. */
  typedef struct winding_regions
  {
    uint32_t size;             /**< bytes of the struct that its caller knows */
    const char* kind;          /**< Object, Group, Material or Solid */
    int64_t count;             /**< of regions, 2 or more */
    const char* const* names;  /**< one each, in UTF-8; empty for polygons without a name */
    const int32_t* of_polygon; /**< for each polygon its region, from 0 on */
  } winding_regions;

  /**
   * Fills a struct with the defaults.
   *
   * @param regions the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_regions_init(winding_regions* regions, size_t size);

  /**
   * Shows the regions of one kind that a file names: the objects (o), groups (g) and materials
   * (usemtl) of .obj, the solids of .stl. They live until winding_mesh_free().
   *
   * @param mesh the mesh
   * @param index less than regions_count
   * @param regions receives the pointers; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_mesh_regions(
    const winding_mesh* mesh, int64_t index, winding_regions* regions, winding_refusal* refusal);

  /** How near a surface is to the source that it was made of. */
  typedef struct winding_fidelity
  {
    uint32_t size;              /**< bytes of the struct that its caller knows */
    int64_t samples;            /**< points drawn from each of the two */
    double largest_from_source; /**< distance of the source from the surface */
    double mean_from_source;    /**< of these distances */
    double largest_to_source;   /**< distance of the surface from the source */
    double mean_to_source;      /**< of these distances */
    double source_volume;       /**< NaN where the source is not closed */
    double volume;              /**< of the surface */
    int64_t components;         /**< connected parts of the source */
    int64_t lost_components;    /**< that the surface has nothing of */
    int64_t self_intersections; /**< of the surface */
    double largest_shape_error; /**< of the surface, off the wanted distances; NaN for none */
    double mean_shape_error;    /**< of these errors */
  } winding_fidelity;

  /**
   * Fills a struct with the defaults.
   *
   * @param fidelity the struct; null is left alone
   * @param size sizeof of the struct
   */
  WINDING_API void winding_fidelity_init(winding_fidelity* fidelity, size_t size);

  /**
   * Compares a mesh with the source of a field.
   *
   * @param field the field
   * @param mesh the mesh
   * @param voxel size of the largest voxel that the mesh was made with
   * @param samples points to draw from each, 1 or more
   * @param run null for the defaults
   * @param fidelity receives the figures; its size is set
   * @param refusal receives why the call was refused, unless it is null
   */
  WINDING_API winding_status winding_compare(const winding_field* field, const winding_mesh* mesh,
    double voxel, int64_t samples, const winding_run* run, winding_fidelity* fidelity,
    winding_refusal* refusal);

#ifdef __cplusplus
}
#endif

#endif
