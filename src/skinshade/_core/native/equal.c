/* Groups of equal rows: vertices at one position, and faces with the same corners in the same order.
 * NumPy twins: weld of skinshade/mesh/topology.py and _first_of_equal of skinshade/mesh/model.py.
 *
 * Rows are distributed to buckets by a hash, in increasing order within each bucket. A bucket and its hash table
 * fit in a cache. A row matches the first row that is equal to it; the hash only finds candidates.
 */
#include "rows.h"

#include <string.h>

SKN_INLINE void row_key(const void *rows, int32_t kind, int64_t i, uint64_t key[3])
{
    if (kind == SKN_F32 || kind == SKN_F64) {
        double row[3];
        skn_row(rows, kind, i, row);
        for (int axis = 0; axis < 3; axis++) {
            const double value = row[axis] + 0.0; /* -0 becomes 0 */
            memcpy(key + axis, &value, sizeof value);
        }
        return;
    }
    int64_t face[3];
    skn_face(rows, kind, i, face);
    /* The least corner comes first; the order around the face stays. */
    const int turn = face[1] < face[0] ? (face[2] < face[1] ? 2 : 1) : (face[2] < face[0] ? 2 : 0);
    key[0] = (uint64_t)face[turn];
    key[1] = (uint64_t)face[turn == 2 ? 0 : turn + 1];
    key[2] = (uint64_t)face[turn == 0 ? 2 : turn - 1];
}

SKN_INLINE uint64_t key_hash(const uint64_t key[3])
{
    uint64_t hash = key[0] * 0x9E3779B97F4A7C15u;
    hash = (hash ^ (hash >> 32) ^ key[1]) * 0xC2B2AE3D27D4EB4Fu;
    hash = (hash ^ (hash >> 29) ^ key[2]) * 0xD6E8FEB86659FD93u;
    return hash ^ (hash >> 32);
}

SKN_INLINE uint64_t row_hash(const void *rows, int32_t kind, int64_t i)
{
    uint64_t key[3];
    row_key(rows, kind, i, key);
    return key_hash(key);
}

SKN_INLINE void count_rows(const void *rows, int32_t kind, int64_t first, int64_t last, int32_t shift,
                           uint32_t *counts)
{
    for (int64_t i = first; i < last; i++)
        counts[row_hash(rows, kind, i) >> shift]++;
}

SKN_INLINE void scatter_rows(const void *rows, int32_t kind, int64_t first, int64_t last, int32_t shift,
                             uint32_t *cursors, uint64_t *entries)
{
    for (int64_t i = first; i < last; i++) {
        const uint64_t hash = row_hash(rows, kind, i);
        entries[cursors[hash >> shift]++] = hash << 32 | (uint64_t)i;
    }
}

SKN_INLINE int same_row(const void *rows, int32_t kind, int64_t i, int64_t j)
{
    uint64_t a[3], b[3];
    row_key(rows, kind, i, a);
    row_key(rows, kind, j, b);
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

SKN_INLINE int64_t match_rows(const void *rows, int32_t kind, const uint64_t *entries, const uint32_t *starts,
                              int64_t first, int64_t last, uint32_t *table, uint32_t *match)
{
    int64_t repeated = 0;
    for (int64_t bucket = first; bucket < last; bucket++) {
        const uint64_t *entry = entries + starts[bucket];
        const uint32_t count = starts[bucket + 1] - starts[bucket];
        uint32_t mask = 15;
        while (mask + 1 < 2 * (uint64_t)count)
            mask = 2 * mask + 1;
        memset(table, 0, ((size_t)mask + 1) * sizeof *table);
        for (uint32_t i = 0; i < count; i++) {
            uint32_t slot = (uint32_t)(entry[i] >> 32) & mask;
            while (table[slot] != 0) {
                const uint64_t other = entry[table[slot] - 1];
                if (other >> 32 == entry[i] >> 32 &&
                    same_row(rows, kind, (int64_t)(uint32_t)other, (int64_t)(uint32_t)entry[i])) {
                    match[(uint32_t)entry[i]] = (uint32_t)other;
                    repeated++;
                    break;
                }
                slot = (slot + 1) & mask;
            }
            if (table[slot] == 0)
                table[slot] = i + 1;
        }
    }
    return repeated;
}

#define WITH_KIND(call)                  \
    switch (kind) {                      \
    case SKN_F32:                        \
        call(SKN_F32);                   \
        break;                           \
    case SKN_F64:                        \
        call(SKN_F64);                   \
        break;                           \
    case SKN_I32:                        \
        call(SKN_I32);                   \
        break;                           \
    default:                             \
        call(SKN_I64);                   \
    }

/* Adds the rows of every bucket to counts; a bucket is the hash >> shift. */
void SKN(equal_count)(const void *rows, int32_t kind, int64_t first, int64_t last, int32_t shift, uint32_t *counts)
{
#define COUNT(constant) count_rows(rows, constant, first, last, shift, counts)
    WITH_KIND(COUNT)
}

/* Writes the rows to their buckets, as hash << 32 | row, and matches every row with itself. */
void SKN(equal_scatter)(const void *rows, int32_t kind, int64_t first, int64_t last, int32_t shift,
                        uint32_t *cursors, uint64_t *entries, uint32_t *match)
{
#define SCATTER(constant) scatter_rows(rows, constant, first, last, shift, cursors, entries)
    WITH_KIND(SCATTER)
    for (int64_t i = first; i < last; i++)
        match[i] = (uint32_t)i;
}

/* Matches the rows of buckets with the first equal row; returns how many rows are not the first.
 * The table needs twice as many numbers as the largest bucket has rows, rounded up to a power of two. */
int64_t SKN(equal_match)(const void *rows, int32_t kind, const uint64_t *entries, const uint32_t *starts,
                         int64_t first, int64_t last, uint32_t *table, uint32_t *match)
{
    int64_t repeated;
#define MATCH(constant) repeated = match_rows(rows, constant, entries, starts, first, last, table, match)
    WITH_KIND(MATCH)
    return repeated;
}

/* Returns how many rows of a range match themselves. */
int64_t SKN(equal_firsts)(const uint32_t *match, int64_t first, int64_t last)
{
    int64_t firsts = 0;
    for (int64_t i = first; i < last; i++)
        firsts += match[i] == (uint32_t)i;
    return firsts;
}

/* Numbers the first rows of groups from `number` on. */
void SKN(equal_number)(const uint32_t *match, int64_t first, int64_t last, int64_t number, uint32_t *numbers,
                       uint32_t *firsts)
{
    for (int64_t i = first; i < last; i++) {
        if (match[i] == (uint32_t)i) {
            firsts[number] = (uint32_t)i;
            numbers[i] = (uint32_t)number++;
        }
    }
}

/* Writes the group of every row. */
void SKN(equal_group)(const uint32_t *match, const uint32_t *numbers, int64_t first, int64_t last, uint32_t *group)
{
    for (int64_t i = first; i < last; i++)
        group[i] = numbers[match[i]];
}
