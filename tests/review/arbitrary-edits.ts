import fc from 'fast-check';
import { KINDS, kindOfList, type LevelFile, notesInOrder, OBJECT_LISTS, type ObjectList, withIds } from '../../schema/index.ts';

export type Json = Record<string, unknown>;

/** A change of a level by numbers, which select what it changes. */
export interface Edit {
  readonly what: number;
  readonly which: number;
  readonly value: number;
}

export const arbitraryEdits = (most: number): fc.Arbitrary<Edit[]> =>
  fc.array(fc.record({ what: fc.nat(19), which: fc.nat(60), value: fc.integer({ min: 1, max: 12 }) }), { maxLength: most });

/** Every object of a level with its list, and every run. */
export function entriesOf(file: LevelFile): Map<string, { list: string; entry: Json }> {
  const entries = new Map<string, { list: string; entry: Json }>();
  for (const list of OBJECT_LISTS)
    for (const entry of file[list] ?? []) entries.set(entry.id as string, { list, entry: entry as Json });
  for (const run of file.runs ?? []) entries.set(`run ${run.name}`, { list: 'runs', entry: run as Json });
  return entries;
}

const minimal = (list: ObjectList, from: Json): Json => {
  const { fields } = KINDS[kindOfList(list)];
  const required = Object.entries(fields as Record<string, { default?: unknown }>).filter(
    ([, field]) => field.default === undefined,
  );
  return { id: from.id, ...Object.fromEntries(required.map(([name]) => [name, from[name] ?? 20])) };
};

/**
 * Applies an edit. @returns what it is about: `''` if there was nothing to change. Edits about different things are apart.
 */
export function apply(file: LevelFile, { what, which, value }: Edit): string {
  const draft = file as unknown as Record<string, unknown>;
  const lists = OBJECT_LISTS.filter((list) => (file[list] ?? []).length > 0);
  const list = lists[which % Math.max(1, lists.length)];
  const objects = (list === undefined ? [] : file[list]) as unknown as Json[];
  const object = objects[value % Math.max(1, objects.length)];
  const runs = (file.runs ?? []) as unknown as Json[];
  const run = runs[which % Math.max(1, runs.length)];
  switch (what) {
    case 0:
    case 1:
    case 2:
      if (object === undefined) return '';
      object.x = value * 7;
      return `${object.id} place`;
    case 3:
      if (object?.radius === undefined) return '';
      object.radius = value;
      return `${object.id} radius`;
    case 4:
      if (object === undefined) return '';
      object['x-own'] = { value };
      return `${object.id} x-own`;
    case 5:
    case 6:
      if (object === undefined) return '';
      objects.splice(objects.indexOf(object), 1);
      return `${object.id}`;
    case 7:
    case 8: {
      const to = OBJECT_LISTS[which % OBJECT_LISTS.length];
      const now = (file[to] ?? []) as unknown as Json[];
      const id = ['order', 'aa', 'bb', 'cc', 'dd', 'ee', 'ff'][value % 7];
      if (entriesOf(file).has(id)) return '';
      draft[to] = [...now];
      (draft[to] as Json[]).splice(which % (now.length + 1), 0, minimal(to, { id, x: value, y: which % 3 }));
      return id;
    }
    case 9: {
      if (object === undefined) return '';
      const to = OBJECT_LISTS[value % OBJECT_LISTS.length];
      if (to === list) return '';
      objects.splice(objects.indexOf(object), 1);
      const own = object['x-own'] === undefined ? {} : { 'x-own': object['x-own'] };
      draft[to] = [...((file[to] ?? []) as unknown as Json[]), { ...minimal(to, object), ...own }];
      return `${object.id}`;
    }
    case 10:
      if (objects.length < 2) return '';
      objects.push(objects.shift() as Json);
      return `order ${list}`;
    case 11:
      if (run === undefined) return '';
      run.holds = [[value, value + 5]];
      return `run ${run.name} holds`;
    case 12:
      if (run === undefined) return '';
      runs.splice(runs.indexOf(run), 1);
      return `run ${run.name}`;
    case 13: {
      const name = ['order', 'a/b', 'a', 'a,b', 'a~1b'][which % 5];
      if (runs.some((one) => one.name === name)) return '';
      draft.runs = [...runs, { name, holds: [[value, value + 9]] }];
      return `run ${name}`;
    }
    case 14: {
      draft.rules = { ...file.rules, [which % 2 === 0 ? 'pull' : 'x-a/b']: value };
      return `rules ${which % 2}`;
    }
    case 15:
      draft[which % 2 === 0 ? 'x-mine' : 'x-a/b'] = { value };
      return `own ${which % 2}`;
    case 16:
      if (which % 3 === 0) delete draft.description;
      else draft[['name', 'name', 'description'][which % 3]] = `text ${value}`;
      return `text ${which % 3 === 1}`;
    case 17:
    case 18: {
      if (run === undefined) return '';
      const notes = (run.notes ?? []) as { tick: number; text: string }[];
      const note = { tick: value * 3, text: `note ${which % 5}` };
      const at = notes.findIndex(({ tick, text }) => tick === note.tick && text === note.text);
      if (what === 17 && at < 0) run.notes = notesInOrder([...notes, note]);
      else if (what === 18 && notes.length > 0) notes.splice(value % notes.length, 1);
      else return '';
      return `run ${run.name} notes`;
    }
    default:
      if (which % 2 === 0) file.astronaut.vx = value;
      else file.blackHole.y = value;
      return `single ${which % 2}`;
  }
}

/** A copy of a level with edits. */
export function edited(base: LevelFile, edits: readonly Edit[]): LevelFile {
  const file = structuredClone(base);
  for (const edit of edits) apply(file, edit);
  return withIds(file);
}
