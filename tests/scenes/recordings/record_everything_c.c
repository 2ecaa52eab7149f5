#include "record_everything.h"

int record_everything_in_c(const char* path);
int record_everything_in_c(const char* path) { return record_everything(path); }

/* A mesh that is larger than a block, and an open file that nobody closes. */
int record_and_crash(const char* path);
int record_and_crash(const char* path) {
    static float vertices[3 * 30000];
    static const uint32_t indices[] = {0, 1, 29999};
    static scb_recorder r; /* static: what is not written is lost */
    size_t i;
    for (i = 0; i < 3 * 30000; ++i) vertices[i] = (float)i;
    if (scb_record_open(&r, path, "crash") != 0) return 1;
    scb_record_mesh(&r, 0, "large", vertices, 4, 0, 30000, indices, 4, 1);
    scb_record_frame(&r, 0);
    scb_record_query(&r, 0, 0);
    scb_record_flush(&r);
    scb_record_test(&r, 1, 2, 3);
    fclose(r.file);
    free(r.crc_tables);
    return 0;
}

/* A recorder that could not be opened, or never was. */
int record_nowhere(const char* path);
int record_nowhere(const char* path) {
    static const double ball[] = {0, 0, 0, 1};
    const scb_record_volume volume = {SCB_RECORD_BALL, 4, ball};
    static const scb_recorder zero;
    scb_recorder closed = zero, failed;
    const int error = scb_record_open(&failed, path, "nowhere");
    scb_record_test(&closed, 1, 2, 0);
    scb_record_refit(&closed, 1, 2, &volume);
    scb_record_frame(&failed, 1);
    scb_record_test(&failed, 1, 2, 0);
    scb_record_close(&closed);
    return scb_record_close(&failed) == error ? error : -1;
}
