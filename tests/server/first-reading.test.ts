import { afterEach, beforeEach, expect, it } from 'vitest';
import { createKnownLevels } from '../../cli/serve/known-levels.ts';
import { createEntryReader } from '../../cli/serve/read-entry.ts';
import type { EditEvent } from '../../schema/index.ts';
import { levelText, makeFolder } from './running.ts';

// A folder with more levels than are read at once.

let made: ReturnType<typeof makeFolder>;
const COUNT = 1700;
beforeEach(() => {
  const text = levelText('same');
  made = makeFolder(Object.fromEntries(Array.from({ length: COUNT }, (_, i) => [`${i}.level.json`, text])));
});
afterEach(() => made.remove());

function open() {
  const known = createKnownLevels(
    made.folder,
    'shown',
    createEntryReader((id) => id),
  );
  const events: EditEvent[] = [];
  known.listen((event) => events.push(event));
  return { known, events };
}
const turns = async (count: number) => {
  for (let i = 0; i < count; i++) await new Promise(setImmediate);
};

it('a large folder is read bit by bit, and reported in parts of 1000 with the number of unread files', async () => {
  const { known, events } = open();
  expect([known.list().levels.length, known.list().unread, events]).toEqual([500, COUNT - 500, []]);
  // a refresh during the first reading reads nothing
  expect((await known.refresh()).unread).toBe(COUNT - 500);
  for (let i = 0; i < 5000 && known.list().unread > 0; i++) await turns(1);
  await turns(5);
  const told = events.map((event) => (event.type === 'read' ? [event.levels.length, event.unread] : event.type));
  expect(told).toEqual([
    [1000, 200],
    [200, 0],
  ]);
  const { levels, unread } = await known.refresh();
  expect([levels.map(({ id }) => id), unread]).toEqual([Array.from({ length: COUNT }, (_, i) => `${i}`), 0]);
  expect(events).toHaveLength(2);
});

it('a large folder is not read any further after end()', async () => {
  const { known, events } = open();
  known.end();
  await turns(200);
  expect([known.list().unread, events]).toEqual([COUNT - 500, []]);
  await known.refresh();
  expect(known.list().levels).toHaveLength(500);
});
