#ifndef CAROM_CAROM_H
#define CAROM_CAROM_H

#include <stddef.h>
#include <stdint.h>

/* The engine for C and for languages that call C: a world in motion. Meanings, units and limits are
   those of world.hpp. A function that can fail returns 0 or NULL and puts the reason, as one line of
   UTF-8 that ends with a zero, into `error`, which has room for `room` bytes (0: not wanted); it has
   changed nothing then. Worlds must not be NULL, except where it is said. If memory is short where a
   function has no error to tell, the program ends. */

#define CAROM_API __attribute__((visibility("default")))
#ifdef __cplusplus
extern "C" {
#endif

typedef struct carom_world carom_world;

/* All balls, an entry a ball in each array, by index. Good until the world is changed. */
typedef struct {
  size_t size;     /* with a lead that is out of play, which is ball 0 */
  int lead_is_out; /* ball 0 waits to be placed */
  const double *x, *y;   /* px, the centre */
  const double *vx, *vy; /* px/s */
  const double* radius;  /* px */
  const double* solidity;
  const uint32_t* id;
  const uint8_t* role; /* 0 neutral, 1 cue, 2 red, 3 enemy, 4 projectile */
} carom_balls;

/* An event of a step (event.hpp). */
typedef struct {
  uint64_t step; /* carom_steps() after it */
  uint8_t kind;  /* 0 pair, 1 cushion, 2 floor, 3 wall, 4 cap, 5 damage, 6 pocketed, 7 destroyed,
                    8 left */
  uint32_t ball, other;
  double x, y;   /* px */
  double dx, dy; /* px/s, the deviation */
  double damage, solidity;
} carom_event;

/* The library's version, "0.1.0". */
CAROM_API const char* carom_version(void);

/* A world of a scene file's bytes; NULL if it is wrong. To be freed. */
CAROM_API carom_world* carom_read(const char* json, size_t size, char* error, size_t room);
/* The same state once more; NULL if memory is short. To be freed. */
CAROM_API carom_world* carom_copy(const carom_world* world);
/* NULL does nothing. */
CAROM_API void carom_free(carom_world* world);

/* Takes steps: at most `most`, fewer if it comes to rest and `until_rest` is not 0. Returns their
   number. */
CAROM_API uint64_t carom_run(carom_world* world, uint64_t most, int until_rest);
/* The events of the last carom_run, in order: their number. Good until the next. */
CAROM_API size_t carom_events(const carom_world* world, const carom_event** events);
CAROM_API void carom_get_balls(const carom_world* world, carom_balls* balls);
/* Steps since the scene's start. */
CAROM_API uint64_t carom_steps(const carom_world* world);
CAROM_API int carom_at_rest(const carom_world* world);
/* The hash of the state: equal states have equal ones. */
CAROM_API uint64_t carom_state_hash(const carom_world* world);

/* Both return 1, or 0 if they refuse. */
CAROM_API int carom_set_velocity(carom_world* world, size_t index, double vx, double vy,
                                 char* error, size_t room);
CAROM_API int carom_place_lead(carom_world* world, double x, double y, char* error, size_t room);

/* The state as bytes: their number. They are written if they are at most `room`. */
CAROM_API size_t carom_save(const carom_world* world, void* bytes, size_t room);
/* The world of such bytes; NULL if it refuses. To be freed. */
CAROM_API carom_world* carom_load(const void* bytes, size_t size, char* error, size_t room);

#ifdef __cplusplus
}
#endif
#endif
