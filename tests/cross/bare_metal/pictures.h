/* Pictures that are the same on every machine, each as a line: its name, and a sum over its bytes.
 */
#ifndef PICTURES_H
#define PICTURES_H

/* 0, or 1 where a call was refused. Allocates nothing. */
int draw_pictures(void (*say)(const char* line));

#endif
