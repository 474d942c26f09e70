#include <stdio.h>

#include "pictures.h"

static void say(const char* line) { puts(line); }

int main(void) { return draw_pictures(say); }
