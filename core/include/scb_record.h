/** @file
 * scb_record.h: writes what a collision engine has (meshes, bounding volume hierarchies, poses) and
 * what its queries do (each test of two volumes, of two triangles, the pairs that it reports) to a
 * file, a recording (.scbrec).
 *
 * C99 and C++, no dependency but the standard library. Copy it into your engine, define
 * SCB_RECORD_ON where you want to record, and put each call into SCB_RECORD(...), which expands to
 * nothing otherwise:
 *
 *     #define SCB_RECORD_ON
 *     #include <scb_record.h>
 *
 *     SCB_RECORD(scb_record_test(&recorder, a, b, overlap ? 0 : 1);)
 *
 * After `if` or `for`, put braces around it. Put parameters of type scb_recorder, and the constants
 * below, inside SCB_RECORD too, or between `#ifdef SCB_RECORD_ON` and `#endif`.
 *
 * A recorder belongs to one thread. It allocates memory once, when it is opened. Calls append to
 * the file, in blocks. After a crash, the file can be read up to its last whole block. An error
 * does not stop your engine: nothing more is written, and scb_record_close returns the error.
 *
 * Lengths are in your units; vectors are columns. A pose is twelve numbers, the rows of a 3x4
 * matrix: x_world = R x_body + t. You number trees, bodies, nodes and meshes; number nodes from 0
 * on, without gaps, if you can. The format: scenes/recordings/README.md of the project. */
#ifndef SCB_RECORD_H
#define SCB_RECORD_H

#ifndef SCB_RECORD_ON
#define SCB_RECORD(...)
#else
/** Its argument is compiled only if SCB_RECORD_ON is defined. */
#define SCB_RECORD(...) __VA_ARGS__

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SCB_RECORD_NONE UINT32_MAX /**< no mesh, no parent, no tree */

/** A recorder. Zero it ({0}) or open it; zeroed, it records nothing. */
typedef struct scb_recorder {
    FILE* file;                  /**< NULL: nothing is recorded */
    unsigned char* data;         /**< of the current block */
    size_t size,                 /**< bytes in it */
        capacity;                /**< bytes that it can hold */
    uint32_t (*crc_tables)[256]; /**< sixteen */
    uint32_t crc;                /**< of the written part of the block */
    int past_block;              /**< a record larger than `data` is being written */
    int error;                   /**< an errno; 0: none */
} scb_recorder;

/** The volumes of nodes, and their numbers in `values`. */
typedef enum scb_record_kind {
    SCB_RECORD_NO_VOLUME = 0, /**< none: 0 */
    SCB_RECORD_AABB = 1,      /**< lower corner, upper corner: 6, along the axes of the body */
    SCB_RECORD_OBB = 2,       /**< center, three axes (unit, at right angles), half sides: 15 */
    SCB_RECORD_BALL = 3,      /**< center, radius: 4 */
    SCB_RECORD_CAPSULE = 4,   /**< two ends, radius: 7 */
    SCB_RECORD_RSS = 5,  /**< a corner of the rectangle, its two sides as vectors, radius: 10 */
    SCB_RECORD_KDOP = 6, /**< per direction of the tree the least and the greatest x.d: 2 n */
    SCB_RECORD_SCB = 7,  /**< center, radius, unit normal n, e, f with f <= (x - c).n <= e: 9 */
    SCB_RECORD_SCB2 = 8, /**< the same and a second slab: 14 */
    SCB_RECORD_HULL = 9  /**< the points of a convex hull: 3 n */
} scb_record_kind;

/** A volume, in the frame of the body. */
typedef struct scb_record_volume {
    scb_record_kind kind; /**< says what the values are */
    uint32_t count;       /**< of values */
    const double* values; /**< lengths in your units */
} scb_record_volume;

/** A node. Leave members that your engine does not have 0, except `parent`. */
typedef struct scb_record_node_data {
    uint32_t parent;          /**< SCB_RECORD_NONE: a root */
    uint64_t id;              /**< its name in the engine: an index, an address */
    const char* name;         /**< or NULL */
    const uint32_t* children; /**< numbers of nodes */
    uint32_t child_count;     /**< how many children it has */
    const uint32_t* items;    /**< of a leaf: triangles of the mesh, or the engine's objects */
    uint32_t item_count;      /**< how many items it has */
    scb_record_volume volume; /**< may be none */
} scb_record_node_data;

/* ---- Inside: bytes, blocks, checksums ------------------------------------------------------- */

static inline void scb_rec_u32(unsigned char* at, uint32_t v) {
    at[0] = (unsigned char)v;
    at[1] = (unsigned char)(v >> 8);
    at[2] = (unsigned char)(v >> 16);
    at[3] = (unsigned char)(v >> 24);
}

/* The polynomial of zlib's crc32, reflected; sixteen bytes at a time (Kounavis and Berry, "Novel
 * table lookup-based algorithms for high-performance CRC generation", 2008). */
static inline void scb_rec_make_tables(uint32_t (*t)[256]) {
    int i, k;
    for (i = 0; i < 256; ++i) {
        uint32_t c = (uint32_t)i;
        for (k = 0; k < 8; ++k) c = (c >> 1) ^ (0xEDB88320u & (0u - (c & 1u)));
        t[0][i] = c;
    }
    for (k = 1; k < 16; ++k)
        for (i = 0; i < 256; ++i) t[k][i] = (t[k - 1][i] >> 8) ^ t[0][t[k - 1][i] & 255u];
}

static inline uint32_t scb_rec_crc(uint32_t (*t)[256], uint32_t crc, const unsigned char* p,
                                   size_t n) {
    crc = ~crc;
    for (; n >= 16; n -= 16, p += 16)
        crc = t[15][p[0] ^ (crc & 255u)] ^ t[14][p[1] ^ ((crc >> 8) & 255u)] ^
              t[13][p[2] ^ ((crc >> 16) & 255u)] ^ t[12][p[3] ^ (crc >> 24)] ^ t[11][p[4]] ^
              t[10][p[5]] ^ t[9][p[6]] ^ t[8][p[7]] ^ t[7][p[8]] ^ t[6][p[9]] ^ t[5][p[10]] ^
              t[4][p[11]] ^ t[3][p[12]] ^ t[2][p[13]] ^ t[1][p[14]] ^ t[0][p[15]];
    for (; n > 0; --n, ++p) crc = t[0][*p ^ (crc & 255u)] ^ (crc >> 8);
    return ~crc;
}

static inline void scb_rec_write(scb_recorder* r, const void* bytes, size_t n) {
    if (r->error == 0 && n > 0 && fwrite(bytes, 1, n, r->file) != n)
        r->error = errno != 0 ? errno : EIO;
}

static inline void scb_rec_start_block(scb_recorder* r, uint32_t length) {
    unsigned char head[8] = {0, 0, 0, 0, 'd', 'a', 't', 'a'};
    scb_rec_u32(head, length);
    r->crc = scb_rec_crc(r->crc_tables, 0, head + 4, 4);
    scb_rec_write(r, head, 8);
}

/* Writes the block up to here. */
static inline void scb_rec_spill(scb_recorder* r) {
    r->crc = scb_rec_crc(r->crc_tables, r->crc, r->data, r->size);
    scb_rec_write(r, r->data, r->size);
    r->size = 0;
}

static inline void scb_rec_end_block(scb_recorder* r) {
    unsigned char tail[4];
    scb_rec_spill(r);
    scb_rec_u32(tail, r->crc);
    scb_rec_write(r, tail, 4);
}

/** Writes the current block, so that the file has all records even if the program crashes. */
static inline void scb_record_flush(scb_recorder* r) {
    if (r->size == 0) return;
    scb_rec_start_block(r, (uint32_t)r->size);
    scb_rec_end_block(r);
}

static inline int scb_rec_has_room(scb_recorder* r, size_t n) {
    if (r->capacity - r->size >= n) return 1;
    if (r->capacity < n) return 0;
    scb_record_flush(r);
    return 1;
}

static inline void scb_rec_event(scb_recorder* r, unsigned char tag, uint32_t a, uint32_t b) {
    unsigned char* at;
    if (r->capacity - r->size < 9 && !scb_rec_has_room(r, 9)) return;
    at = r->data + r->size;
    at[0] = tag;
    scb_rec_u32(at + 1, a);
    scb_rec_u32(at + 5, b);
    r->size += 9;
}

static inline void scb_rec_bytes(scb_recorder* r, const void* bytes, size_t n) {
    const unsigned char* p = (const unsigned char*)bytes;
    while (n > 0 && r->capacity != 0) {
        const size_t room = r->capacity - r->size, part = n < room ? n : room;
        memcpy(r->data + r->size, p, part);
        r->size += part;
        p += part;
        n -= part;
        if (n > 0) scb_rec_spill(r); /* the record is larger than a block */
    }
}

static inline void scb_rec_put8(scb_recorder* r, unsigned v) {
    unsigned char byte = (unsigned char)v;
    scb_rec_bytes(r, &byte, 1);
}

static inline void scb_rec_put32(scb_recorder* r, uint32_t v) {
    unsigned char bytes[4];
    scb_rec_u32(bytes, v);
    scb_rec_bytes(r, bytes, 4);
}

static inline void scb_rec_put64(scb_recorder* r, uint64_t v) {
    scb_rec_put32(r, (uint32_t)v);
    scb_rec_put32(r, (uint32_t)(v >> 32));
}

static inline void scb_rec_doubles(scb_recorder* r, const double* v, size_t n) {
    size_t i;
    for (i = 0; i < n; ++i) {
        uint64_t bits;
        memcpy(&bits, &v[i], 8);
        scb_rec_put64(r, bits);
    }
}

static inline void scb_rec_u32s(scb_recorder* r, const uint32_t* v, uint32_t n) {
    uint32_t i;
    scb_rec_put32(r, n);
    for (i = 0; i < n; ++i) scb_rec_put32(r, v[i]);
}

static inline size_t scb_rec_text_size(const char* text) { return 4 + (text ? strlen(text) : 0); }

static inline void scb_rec_text(scb_recorder* r, const char* text) {
    const size_t n = scb_rec_text_size(text) - 4;
    scb_rec_put32(r, (uint32_t)n);
    scb_rec_bytes(r, text, n);
}

/* Begins a record of `length` bytes: in the block, or as a block of its own. */
static inline void scb_rec_begin(scb_recorder* r, unsigned tag, uint64_t length) {
    if (r->capacity == 0) return;
    if (length > UINT32_MAX - 5) {
        r->error = EFBIG;
        r->capacity = r->size = 0;
        return;
    }
    if (!scb_rec_has_room(r, (size_t)length + 5)) {
        scb_record_flush(r);
        scb_rec_start_block(r, (uint32_t)length + 5);
        r->past_block = 1;
    }
    scb_rec_put8(r, tag);
    scb_rec_put32(r, (uint32_t)length);
}

static inline void scb_rec_end(scb_recorder* r) {
    if (!r->past_block) return;
    r->past_block = 0;
    scb_rec_end_block(r);
}

static inline size_t scb_rec_volume_size(const scb_record_volume* v) {
    return 5 + 8 * (size_t)v->count;
}

static inline void scb_rec_put_volume(scb_recorder* r, const scb_record_volume* v) {
    scb_rec_put8(r, (unsigned)v->kind);
    scb_rec_put32(r, v->count);
    scb_rec_doubles(r, v->values, v->count);
}

/* ---- The file ------------------------------------------------------------------------------- */

/** Writes the rest, and a mark that the recording is complete. Returns 0, or the errno of the first
 * error since it was opened. */
static inline int scb_record_close(scb_recorder* r) {
    int error;
    if (r->file) {
        scb_rec_begin(r, 203, 0);
        scb_rec_end(r);
        scb_record_flush(r);
        if (fclose(r->file) != 0 && r->error == 0) r->error = errno != 0 ? errno : EIO;
    }
    free(r->crc_tables);
    error = r->error;
    memset(r, 0, sizeof *r);
    return error;
}

/** Creates the file, or empties it. `engine`: its name and version, "Bullet 3.24". Returns 0, or
 * an errno; the recorder can be used in either case. */
static inline int scb_record_open(scb_recorder* r, const char* path, const char* engine) {
    static const unsigned char magic[12] = {0x89, 's', 'c', 'b', 'r', 'c', 13, 10, 1, 0, 0, 0};
    const size_t tables = 16 * 256 * sizeof(uint32_t), block = 1 << 16;
    memset(r, 0, sizeof *r);
    errno = 0;
    r->file = fopen(path, "wb");
    if (!r->file) return r->error = errno != 0 ? errno : EIO;
    r->crc_tables = (uint32_t(*)[256])malloc(tables + block);
    if (!r->crc_tables) {
        fclose(r->file);
        r->file = NULL;
        return r->error = ENOMEM;
    }
    scb_rec_make_tables(r->crc_tables);
    r->data = (unsigned char*)r->crc_tables + tables;
    r->capacity = block;
    setvbuf(r->file, NULL, _IONBF, 0); /* the block is the buffer */
    scb_rec_write(r, magic, sizeof magic);
    scb_rec_begin(r, 192, scb_rec_text_size("engine") + scb_rec_text_size(engine));
    scb_rec_text(r, "engine");
    scb_rec_text(r, engine);
    scb_rec_end(r);
    return r->error == 0 ? 0 : (r->error = scb_record_close(r));
}

/* ---- Meshes, trees, bodies ------------------------------------------------------------------ */

/** A setting of the engine, or of the queries that follow: "margin", "0.04". */
static inline void scb_record_setting(scb_recorder* r, const char* key, const char* value) {
    scb_rec_begin(r, 192, scb_rec_text_size(key) + scb_rec_text_size(value));
    scb_rec_text(r, key);
    scb_rec_text(r, value);
    scb_rec_end(r);
}

/** The name of a stage, 1 to 127, at which a test rejects two volumes: "axis of A". Stage 0 means
 * that the volumes overlap. */
static inline void scb_record_stage(scb_recorder* r, uint8_t stage, const char* name) {
    scb_rec_begin(r, 193, 1 + scb_rec_text_size(name));
    scb_rec_put8(r, stage);
    scb_rec_text(r, name);
    scb_rec_end(r);
}

/** A mesh. Three coordinates per vertex, of 4 (float) or 8 (double) bytes each; from one vertex to
 * the next `vertex_stride` bytes (0: no gaps). Three indices per triangle, of 1, 2, 4 or 8 bytes
 * each, without gaps. */
static inline void scb_record_mesh(scb_recorder* r, uint32_t mesh, const char* name,
                                   const void* vertices, int coordinate_bytes, size_t vertex_stride,
                                   uint32_t vertex_count, const void* indices, int index_bytes,
                                   uint32_t triangle_count) {
    const size_t c = (size_t)coordinate_bytes, w = (size_t)index_bytes;
    const size_t stride = vertex_stride != 0 ? vertex_stride : 3 * c;
    const unsigned char* p;
    uint64_t i, k;
    if (r->capacity == 0) return;
    if ((c != 4 && c != 8) || (w != 1 && w != 2 && w != 4 && w != 8)) {
        r->error = EINVAL;
        r->capacity = r->size = 0;
        return;
    }
    scb_rec_begin(r, 194,
                  4 + scb_rec_text_size(name) + 1 + 8 + 3 * (uint64_t)c * vertex_count +
                      12 * (uint64_t)triangle_count);
    scb_rec_put32(r, mesh);
    scb_rec_text(r, name);
    scb_rec_put8(r, (unsigned)c);
    scb_rec_put32(r, vertex_count);
    scb_rec_put32(r, triangle_count);
    for (i = 0; i < vertex_count; ++i)
        for (k = 0; k < 3; ++k) {
            p = (const unsigned char*)vertices + i * stride + k * c;
            if (c == 8) {
                uint64_t bits;
                memcpy(&bits, p, 8);
                scb_rec_put64(r, bits);
            } else {
                uint32_t bits;
                memcpy(&bits, p, 4);
                scb_rec_put32(r, bits);
            }
        }
    for (i = 0; i < 3 * (uint64_t)triangle_count; ++i) {
        uint64_t index = 0;
        p = (const unsigned char*)indices + i * w;
        if (w == 1) {
            index = *p;
        } else if (w == 2) {
            uint16_t v;
            memcpy(&v, p, 2);
            index = v;
        } else if (w == 4) {
            uint32_t v;
            memcpy(&v, p, 4);
            index = v;
        } else {
            memcpy(&index, p, 8);
        }
        /* An index that does not fit is out of range in the recording too. */
        scb_rec_put32(r, index > UINT32_MAX ? UINT32_MAX : (uint32_t)index);
    }
    scb_rec_end(r);
}

/** A tree over the triangles of a mesh, or over objects (`mesh` is SCB_RECORD_NONE). Its nodes
 * follow. A tree that is recorded again was rebuilt: its earlier nodes are gone. `directions`: the
 * directions of its k-DOPs, three numbers each. */
static inline void scb_record_tree(scb_recorder* r, uint32_t tree, const char* name, uint32_t mesh,
                                   const double* directions, uint32_t direction_count) {
    scb_rec_begin(r, 195, 8 + scb_rec_text_size(name) + 4 + 24 * (uint64_t)direction_count);
    scb_rec_put32(r, tree);
    scb_rec_put32(r, mesh);
    scb_rec_text(r, name);
    scb_rec_put32(r, direction_count);
    scb_rec_doubles(r, directions, 3 * (size_t)direction_count);
    scb_rec_end(r);
}

/** A node of a tree, with all its data. In a later frame, or after a query, it replaces the node of
 * this number. */
static inline void scb_record_node(scb_recorder* r, uint32_t tree, uint32_t node,
                                   const scb_record_node_data* n) {
    scb_rec_begin(r, 196,
                  20 + scb_rec_text_size(n->name) + 8 + 4 * (uint64_t)n->child_count +
                      4 * (uint64_t)n->item_count + scb_rec_volume_size(&n->volume));
    scb_rec_put32(r, tree);
    scb_rec_put32(r, node);
    scb_rec_put32(r, n->parent);
    scb_rec_put64(r, n->id);
    scb_rec_text(r, n->name);
    scb_rec_u32s(r, n->children, n->child_count);
    scb_rec_u32s(r, n->items, n->item_count);
    scb_rec_put_volume(r, &n->volume);
    scb_rec_end(r);
}

/** The refitted volume of a node, from now on. */
static inline void scb_record_refit(scb_recorder* r, uint32_t tree, uint32_t node,
                                    const scb_record_volume* volume) {
    scb_rec_begin(r, 197, 8 + scb_rec_volume_size(volume));
    scb_rec_put32(r, tree);
    scb_rec_put32(r, node);
    scb_rec_put_volume(r, volume);
    scb_rec_end(r);
}

/** The extent of an object of a tree without mesh, in the tree's frame, from now on. With it, the
 * judgement checks that leaves contain their objects, and finds missed pairs of objects. */
static inline void scb_record_object(scb_recorder* r, uint32_t tree, uint32_t object,
                                     const scb_record_volume* volume) {
    scb_rec_begin(r, 204, 8 + scb_rec_volume_size(volume));
    scb_rec_put32(r, tree);
    scb_rec_put32(r, object);
    scb_rec_put_volume(r, volume);
    scb_rec_end(r);
}

/** A body: a tree with a pose. Several bodies may have the same tree. */
static inline void scb_record_body(scb_recorder* r, uint32_t body, const char* name,
                                   uint32_t tree) {
    scb_rec_begin(r, 198, 8 + scb_rec_text_size(name));
    scb_rec_put32(r, body);
    scb_rec_put32(r, tree);
    scb_rec_text(r, name);
    scb_rec_end(r);
}

/* ---- Frames, queries, tests ----------------------------------------------------------------- */

/** A frame begins: a step of the simulation. Numbers ascend. */
static inline void scb_record_frame(scb_recorder* r, uint32_t frame) {
    scb_record_flush(r);
    scb_rec_begin(r, 199, 4);
    scb_rec_put32(r, frame);
    scb_rec_end(r);
}

/** The pose of a body from now on. Until its first pose, x_world is x_body. The matrix may also
 * scale, mirror or shear the body. A body that is recorded again keeps its pose. */
static inline void scb_record_pose(scb_recorder* r, uint32_t body, const double pose[12]) {
    scb_rec_begin(r, 200, 4 + 96);
    scb_rec_put32(r, body);
    scb_rec_doubles(r, pose, 12);
    scb_rec_end(r);
}

/** A query of two bodies begins, or of one against itself (the same twice). */
static inline void scb_record_query(scb_recorder* r, uint32_t body_a, uint32_t body_b) {
    scb_rec_begin(r, 201, 8);
    scb_rec_put32(r, body_a);
    scb_rec_put32(r, body_b);
    scb_rec_end(r);
}

/** A query of two bodies begins, with a name and `tag_count` tags. Commands select queries by name
 * and tag: `--query NAME`, `--tag TAG`. `name` and `tags` may be NULL. */
static inline void scb_record_named_query(scb_recorder* r, uint32_t body_a, uint32_t body_b,
                                          const char* name, const char* const* tags,
                                          uint32_t tag_count) {
    uint64_t length = 12 + (uint64_t)scb_rec_text_size(name);
    uint32_t i;
    for (i = 0; i < tag_count; ++i) length += scb_rec_text_size(tags[i]);
    scb_rec_begin(r, 201, length);
    scb_rec_put32(r, body_a);
    scb_rec_put32(r, body_b);
    scb_rec_text(r, name);
    scb_rec_put32(r, tag_count);
    for (i = 0; i < tag_count; ++i) scb_rec_text(r, tags[i]);
    scb_rec_end(r);
}

/** After scb_record_query: this query looks for the smallest distance of the two bodies. `limit`:
 * nothing beyond this distance is looked for; INFINITY if there is no such limit. `relative_error`:
 * the distance may be too large by this share: 0.01 is 1 %. A query that ends at a pair that is
 * near enough is not complete, see scb_record_query_end. */
static inline void scb_record_nearest(scb_recorder* r, double limit, double relative_error) {
    const double values[2] = {limit, relative_error};
    scb_rec_begin(r, 206, 17);
    scb_rec_put8(r, 1);
    scb_rec_doubles(r, values, 2);
    scb_rec_end(r);
}

/** After scb_record_query: this query looks for all pairs whose distance is at most `tolerance`. If
 * it ends at the first pair, it is not complete, see scb_record_query_end. */
static inline void scb_record_within(scb_recorder* r, double tolerance) {
    const double values[2] = {tolerance, 0};
    scb_rec_begin(r, 206, 17);
    scb_rec_put8(r, 2);
    scb_rec_doubles(r, values, 2);
    scb_rec_end(r);
}

/** The answer of scb_record_nearest: the distance that the query returns, and two items that have
 * it, or SCB_RECORD_NONE twice. `points`: three coordinates of the closest point of A and three of
 * the closest point of B, in the world; or NULL. If nothing is nearer than the limit, record no
 * answer. */
static inline void scb_record_distance(scb_recorder* r, double distance, uint32_t item_a,
                                       uint32_t item_b, const double points[6]) {
    scb_rec_begin(r, 207, points ? 68 : 20);
    scb_rec_doubles(r, &distance, 1);
    scb_rec_put32(r, item_a);
    scb_rec_put32(r, item_b);
    scb_rec_put32(r, points ? 6 : 0);
    if (points) scb_rec_doubles(r, points, 6);
    scb_rec_end(r);
}

/** The length that the next test has: the lower bound of the distance of two volumes, or the
 * distance of two items. */
static inline void scb_record_length(scb_recorder* r, double length) {
    uint64_t bits;
    memcpy(&bits, &length, 8);
    scb_rec_event(r, 132, (uint32_t)bits, (uint32_t)(bits >> 32));
}

/** A line of your engine's log, in the current frame. Reports show the line if a test or a pair of
 * the frame is wrong. */
static inline void scb_record_log(scb_recorder* r, const char* text) {
    scb_rec_begin(r, 205, scb_rec_text_size(text));
    scb_rec_text(r, text);
    scb_rec_end(r);
}

/** A test of two volumes, of a node of A and one of B. `stage`: 0 if they overlap, else the part of
 * the test that rejected them, 1 to 127, see scb_record_stage; larger numbers count as 127. */
static inline void scb_record_test(scb_recorder* r, uint32_t node_a, uint32_t node_b,
                                   uint8_t stage) {
    scb_rec_event(r, (unsigned char)(stage < 128 ? stage : 127), node_a, node_b);
}

/** The same for a test that an earlier test led to: `parent` is the number of that test in this
 * query; tests of volumes have the numbers 0, 1, 2, ... Without it, scb takes the latest test of
 * the parents of the nodes. */
static inline void scb_record_step(scb_recorder* r, uint32_t parent, uint32_t node_a,
                                   uint32_t node_b, uint8_t stage) {
    scb_rec_event(r, 131, parent, 0);
    scb_record_test(r, node_a, node_b, stage);
}

/** A test of two triangles, or of two objects: items of leaves. */
static inline void scb_record_items(scb_recorder* r, uint32_t item_a, uint32_t item_b, int meet) {
    scb_rec_event(r, (unsigned char)(meet ? 129 : 128), item_a, item_b);
}

/** A lower bound of the distance of two nodes. A test that leads to no other test counts as left
 * out by its bound. `stage`: 1 to 127 if this test alone left the nodes out, else 0. Do not
 * record a bound that is the square of a length; INFINITY says that the test gave up. */
static inline void scb_record_bound(scb_recorder* r, uint32_t node_a, uint32_t node_b, double bound,
                                    uint8_t stage) {
    scb_record_length(r, bound);
    scb_record_test(r, node_a, node_b, stage);
}

/** The distance of two items that the query measured. */
static inline void scb_record_item_distance(scb_recorder* r, uint32_t item_a, uint32_t item_b,
                                            double distance) {
    scb_record_length(r, distance);
    scb_record_items(r, item_a, item_b, 0);
}

/** A pair that the query reports. */
static inline void scb_record_pair(scb_recorder* r, uint32_t item_a, uint32_t item_b) {
    scb_rec_event(r, 130, item_a, item_b);
}

/** The query ends. `complete`: it found all that it looks for, and did not end early on purpose.
 * `nanoseconds`: its duration, 0 if not measured. */
static inline void scb_record_query_end(scb_recorder* r, int complete, uint64_t nanoseconds) {
    scb_rec_begin(r, 202, 9);
    scb_rec_put8(r, complete ? 1 : 0);
    scb_rec_put64(r, nanoseconds);
    scb_rec_end(r);
}

#ifdef __cplusplus
}
#endif

#endif /* SCB_RECORD_ON */
#endif /* SCB_RECORD_H */
