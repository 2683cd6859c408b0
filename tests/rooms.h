/* rooms.h -- the test files, each with one way in. */
#ifndef ROOMS_H
#define ROOMS_H

void test_core(void);
void test_number(void);
void test_stl(void);
void test_weld(void);
void test_link(void);
void test_check(void);

#endif
