// A plain ray march, to measure Fumetto's against: trilinear density, single scattering, at each step a march toward
// the light; no light grid, no leaps over what is empty. Two threads.
//
// cc -O3 -march=native -ffast-math -pthread march.c -o march -lm
// march DENSITY VOXELS STEP OUT: DENSITY are 32-bit floats, x first, of a box from -1 to 1; STEP is in voxels; OUT are
// width * height floats of light. Prints the milliseconds that it took.

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { WIDTH = 640, HEIGHT = 480, THREADS = 2 };

static const float EXTINCTION = 6.0f, AWAY = 4.0f, FOV = 36.0f, SPENT = 0.001f;
static int side;
static float step;
static float *density, *picture;
static float sun[3];

static float at(const float p[3]) {
    float part[3];
    int cell[3];
    for (int axis = 0; axis < 3; axis++) {
        float index = (p[axis] + 1.0f) * 0.5f * side - 0.5f;
        if (index < 0.0f || index >= side - 1) {
            return 0.0f;
        }
        cell[axis] = (int)index;
        part[axis] = index - cell[axis];
    }
    const float *v = density + ((size_t)cell[2] * side + cell[1]) * side + cell[0];
    const size_t y = side, z = (size_t)side * side;
    float a = v[0] + part[0] * (v[1] - v[0]), b = v[y] + part[0] * (v[y + 1] - v[y]);
    float c = v[z] + part[0] * (v[z + 1] - v[z]), d = v[z + y] + part[0] * (v[z + y + 1] - v[z + y]);
    float low = a + part[1] * (b - a), high = c + part[1] * (d - c);
    return low + part[2] * (high - low);
}

// Where a ray enters and leaves the box.
static void ends(const float p[3], const float way[3], float *near, float *far) {
    for (int axis = 0; axis < 3; axis++) {
        float a = (-1.0f - p[axis]) / way[axis], b = (1.0f - p[axis]) / way[axis];
        *near = fmaxf(*near, fminf(a, b));
        *far = fminf(*far, fmaxf(a, b));
    }
}

static float light_at(const float p[3]) {
    float near = 0.0f, far = 1e9f, sum = 0.0f;
    ends(p, sun, &near, &far);
    for (float t = 0.5f * step; t < far; t += step) {
        float q[3] = {p[0] + t * sun[0], p[1] + t * sun[1], p[2] + t * sun[2]};
        sum += at(q);
    }
    return expf(-EXTINCTION * step * sum);
}

static float seen(int x, int y) {
    float focal = 0.5f * HEIGHT / tanf(FOV * 0.00872664626f);
    float way[3] = {(x + 0.5f - 0.5f * WIDTH) / focal + 1e-9f, -(y + 0.5f - 0.5f * HEIGHT) / focal + 1e-9f, -1.0f};
    float length = sqrtf(way[0] * way[0] + way[1] * way[1] + 1.0f);
    for (int axis = 0; axis < 3; axis++) {
        way[axis] /= length;
    }
    float eye[3] = {0.0f, 0.0f, AWAY}, near = 0.0f, far = 1e9f, left = 1.0f, light = 0.0f;
    ends(eye, way, &near, &far);
    for (float t = near + 0.5f * step; t < far && left > SPENT; t += step) {
        float p[3] = {eye[0] + t * way[0], eye[1] + t * way[1], eye[2] + t * way[2]};
        float here = at(p);
        if (here > 0.0f) {
            float share = left * (1.0f - expf(-EXTINCTION * step * here));
            light += share * light_at(p);
            left -= share;
        }
    }
    return light;
}

static void *rows(void *first) {
    for (int y = *(int *)first; y < HEIGHT; y += THREADS) {
        for (int x = 0; x < WIDTH; x++) {
            picture[y * WIDTH + x] = seen(x, y);
        }
    }
    return NULL;
}

int main(int count, char **words) {
    if (count != 5) {
        fprintf(stderr, "march DENSITY VOXELS STEP OUT\n");
        return 2;
    }
    side = atoi(words[2]);
    step = 2.0f * (float)atof(words[3]) / side;
    size_t voxels = (size_t)side * side * side;
    density = malloc(voxels * sizeof *density);
    picture = malloc(WIDTH * HEIGHT * sizeof *picture);
    FILE *in = fopen(words[1], "rb");
    if (!density || !picture || !in || fread(density, sizeof *density, voxels, in) != voxels) {
        fprintf(stderr, "cannot read %s\n", words[1]);
        return 1;
    }
    float toward[3] = {-0.5f, 1.0f, 0.6f}, length = sqrtf(1.61f);
    for (int axis = 0; axis < 3; axis++) {
        sun[axis] = toward[axis] / length;
    }
    struct timespec begin, end;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    pthread_t threads[THREADS];
    int firsts[THREADS];
    for (int thread = 0; thread < THREADS; thread++) {
        firsts[thread] = thread;
        pthread_create(&threads[thread], NULL, rows, &firsts[thread]);
    }
    for (int thread = 0; thread < THREADS; thread++) {
        pthread_join(threads[thread], NULL);
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    printf("%.1f\n", (end.tv_sec - begin.tv_sec) * 1e3 + (end.tv_nsec - begin.tv_nsec) * 1e-6);
    FILE *out = fopen(words[4], "wb");
    return !out || fwrite(picture, sizeof *picture, WIDTH * HEIGHT, out) != WIDTH * HEIGHT;
}
