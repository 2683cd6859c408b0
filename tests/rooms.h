/* rooms.h -- the test files, each with one way in: one a room of the library, then three that need several. */
#ifndef ROOMS_H
#define ROOMS_H

void test_core(void);
void test_exact(void);
void test_number(void);
void test_stl(void);
void test_weld(void);
void test_link(void);
void test_geometry(void);
void test_check(void);
void test_walk(void);
void test_trees(void);
void test_normals(void);
void test_edit(void);
void test_sew(void);
void test_hull(void);
void test_levels(void);
void test_smooth(void);
void test_orient(void);
void test_simplify(void);
void test_query(void);
void test_bvh(void);
void test_meet(void);
void test_conditions(void);
void test_verdict(void);
void test_worlds(void);
void test_corrupt(void);

#endif
