/* The C interface, used by plain C: plays the scene of a file as main.cpp does and prints the same
   hash, by way of a copy and of saved bytes. */
#include <carom/carom.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char error[200];

static void need(int truth, const char* what) {
  if (truth) return;
  fprintf(stderr, "plain.c: %s: %s\n", what, error);
  exit(1);
}

static carom_world* read_file(const char* name) {
  static char json[1 << 16];
  FILE* file = fopen(name, "rb");
  need(file != NULL, "the scene is there");
  size_t size = fread(json, 1, sizeof json, file);
  fclose(file);
  need(carom_read(json, size / 2, error, sizeof error) == NULL && error[0] != '\0',
       "half a scene is refused with a reason");
  error[0] = '\0';
  return carom_read(json, size, error, sizeof error);
}

int main(int argc, char** argv) {
  need(argc == 2, "one argument");
  need(strcmp(carom_version(), "") != 0, "a version");
  carom_world* start = read_file(argv[1]);
  need(start != NULL, "a world");

  carom_balls balls;
  carom_get_balls(start, &balls);
  need(balls.size == 37 && balls.radius[0] > 0 && balls.id[1] == 1 && balls.role[0] == 1,
       "the balls of the break");
  need(!carom_set_velocity(start, 1000, 1, 0, error, sizeof error), "there is no ball 1000");
  need(carom_place_lead(start, balls.x[0], balls.y[0], error, sizeof error), "a place");
  need(carom_set_velocity(start, 0, balls.vx[0], balls.vy[0], error, sizeof error) == 1,
       "a velocity");
  carom_free(start);
  start = read_file(argv[1]);

  carom_world* world = carom_copy(start);
  need(carom_run(world, 100, 0) == 100 && carom_steps(world) == 100, "a hundred steps");
  const carom_event* events;
  size_t count = carom_events(world, &events);
  need(count > 0 && events[0].kind == 0 && events[0].step > 0 && events[0].step <= 100,
       "collisions");
  need(!carom_at_rest(world), "it moves");

  size_t size = carom_save(world, NULL, 0);
  unsigned char* bytes = malloc(size);
  need(carom_save(world, bytes, size) == size, "bytes");
  carom_world* loaded = carom_load(bytes, size, error, sizeof error);
  need(loaded != NULL, "a loaded world");
  bytes[size / 2] ^= 1;
  need(carom_load(bytes, size, error, 20) == NULL && strlen(error) < 20, "changed bytes");
  free(bytes);
  carom_run(loaded, 100000, 1);
  carom_run(world, 100000, 1);
  need(carom_at_rest(world) && carom_state_hash(world) == carom_state_hash(loaded), "rest");
  printf("%016" PRIx64 "\n", carom_state_hash(world));
  carom_free(loaded);
  carom_free(world);
  carom_free(start);
  return 0;
}
