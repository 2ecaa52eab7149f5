#pragma once

/* Calls every function of scb_record.h once, or more often; the same in C99 and in C++. */
#define SCB_RECORD_ON
#include <scb_record.h>

static inline int record_everything(const char* path) {
    static const float corners[] = {0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9, 0, 0, 1, 9};
    static const double exact[] = {0, 0, 0, 0.1, 0, 0, 0, 0.1, 0};
    static const uint16_t short_indices[] = {0, 1, 2, 0, 1, 3};
    static const uint64_t long_indices[] = {0, 1, (uint64_t)1 << 40};
    static const unsigned char byte_indices[] = {0, 1, 2};
    static const double box[] = {0, 0, 0, 1, 1, 1};
    static const double ball[] = {0, 0, 0, 1};
    static const double directions[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const double slabs[] = {0, 1, 0, 1, 0, 1};
    static const double pose[12] = {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0};
    static const uint32_t children[] = {1, 2};
    static const uint32_t first[] = {0}, second[] = {1};
    static const char* const tags[] = {"grasp", "slow"};
    const scb_record_volume in_box = {SCB_RECORD_AABB, 6, box};
    const scb_record_volume in_ball = {SCB_RECORD_BALL, 4, ball};
    const scb_record_volume in_slabs = {SCB_RECORD_KDOP, 6, slabs};
    scb_record_node_data node = {
        SCB_RECORD_NONE, 0, NULL, NULL, 0, NULL, 0, {SCB_RECORD_NO_VOLUME, 0, NULL}};
    scb_recorder r;
    uint32_t i;

    const int opened = scb_record_open(&r, path, "test 1.0");
    if (opened != 0) return opened;
    scb_record_setting(&r, "margin", "0.04");
    scb_record_stage(&r, 1, "axis of A");
    scb_record_stage(&r, 127, NULL);
    scb_record_mesh(&r, 3, "tetra", corners, 4, 16, 4, short_indices, 2, 2);
    scb_record_mesh(&r, 4, "one", exact, 8, 0, 3, byte_indices, 1, 1);
    scb_record_mesh(&r, 5, "wide", exact, 8, 24, 3, long_indices, 8, 1);

    scb_record_tree(&r, 7, "boxes", 3, NULL, 0);
    node.id = 0xfedcba9876543210u;
    node.name = "root";
    node.children = children;
    node.child_count = 2;
    node.volume = in_box;
    scb_record_node(&r, 7, 0, &node);
    node.parent = 0;
    node.name = NULL;
    node.child_count = 0;
    node.items = first;
    node.item_count = 1;
    node.volume = in_ball;
    scb_record_node(&r, 7, 1, &node);
    node.items = second;
    scb_record_node(&r, 7, 2, &node);
    scb_record_tree(&r, 8, "objects", SCB_RECORD_NONE, directions, 3);
    node.parent = SCB_RECORD_NONE;
    node.volume = in_slabs;
    scb_record_node(&r, 8, 0, &node);
    scb_record_body(&r, 0, "A", 7);
    scb_record_body(&r, 1, "B", 7);

    for (i = 0; i < 2; ++i) {
        uint32_t k;
        scb_record_frame(&r, i);
        scb_record_pose(&r, 1, pose);
        scb_record_refit(&r, 7, 1, &in_box);
        if (i == 0) {
            scb_record_query(&r, 0, 1);
            scb_record_nearest(&r, 2.5, 0.125);
            scb_record_bound(&r, 0, 2, 0.75, 3);
            scb_record_item_distance(&r, 1, 0, -0.25);
            scb_record_distance(&r, 0.5, 1, 0, pose);
            scb_record_distance(&r, 1.5, SCB_RECORD_NONE, SCB_RECORD_NONE, NULL);
        } else {
            scb_record_log(&r, "gripper closed");
            scb_record_named_query(&r, 0, 1, "lift", tags, 2);
            scb_record_within(&r, 0.375);
        }
        scb_record_test(&r, 0, 0, 0);
        /* More than a block of them. */
        for (k = 0; k < 10000; ++k) scb_record_test(&r, k, 2, (uint8_t)(k % 2));
        scb_record_step(&r, 7, 2, 1, 200);
        scb_record_items(&r, 0, 1, 1);
        scb_record_items(&r, 1, 1, 0);
        scb_record_pair(&r, 0, 1);
        scb_record_query_end(&r, 1, 123456789012345u);
    }
    return scb_record_close(&r);
}
