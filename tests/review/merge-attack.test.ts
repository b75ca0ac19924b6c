import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { mergeLevels, resolveConflicts, type Side, shareIds, withConflicts } from '../../review/index.ts';
import { formatLevel, isSame, type LevelFile, OBJECT_LISTS, readLevel, withIds } from '../../schema/index.ts';
import { isHunt } from '../depth.ts';
import { arbitraryFile } from '../editor/arbitrary-file.ts';
import { apply, arbitraryEdits, edited, entriesOf, type Json } from './arbitrary-edits.ts';

// Random levels and random edits of two sides, which often meet in the same object, run, id, name or list.

// a hunt runs every property ten times as often or more: then 10,000 of each
const numRuns = isHunt ? 1000 : 150;

const arbitraryFork = fc
  .record({ base: arbitraryFile, ours: arbitraryEdits(8), theirs: arbitraryEdits(8) })
  .map(({ base, ours, theirs }) => ({ base, mine: edited(base, ours), theirs: edited(base, theirs) }));

/** A level without the order of its lists, and without what is only text: an empty list or none. */
function content(file: LevelFile): unknown {
  const { conflicts: _, ...rest } = file as unknown as Json;
  for (const list of [...OBJECT_LISTS, 'runs']) delete rest[list];
  const rules = rest.rules as object | undefined;
  if (rules !== undefined && Object.keys(rules).length === 0) delete rest.rules;
  return { rest, entries: Object.fromEntries(entriesOf(file)) };
}

const text = (file: LevelFile): string => formatLevel(file);

describe('random merges', () => {
  it('are valid levels, symmetric, idempotent, and lose nothing', () => {
    fc.assert(
      fc.property(arbitraryFork, ({ base, mine, theirs }) => {
        const merged = mergeLevels(base, mine, theirs);
        const marked = withConflicts(merged);
        const reading = readLevel(text(marked));
        if (!reading.ok) throw new Error(reading.problems[0].message);
        expect(isSame(reading.document.file, JSON.parse(JSON.stringify(marked)))).toBe(true);

        const mirrored = mergeLevels(base, theirs, mine);
        const swapped = mirrored.conflicts.map(({ mine, theirs, ...rest }) => ({ ...rest, mine: theirs, theirs: mine }));
        const byKey = (p: { key: string }, q: { key: string }) => (p.key < q.key ? -1 : 1);
        expect([...merged.conflicts].sort(byKey)).toEqual(swapped.sort(byKey));
        expect(new Set(merged.conflicts.map(({ key }) => key)).size).toBe(merged.conflicts.length);
        const all = (side: Side) => new Map(merged.conflicts.map(({ key }) => [key, side]));
        expect(text(mergeLevels(base, theirs, mine, all('theirs')).file)).toBe(text(merged.file));

        expect(mergeLevels(base, mine, mine)).toEqual({ file: mine, conflicts: [] });
        expect(mergeLevels(base, base, mine)).toEqual({ file: mine, conflicts: [] });
        for (const [m, t] of merged.conflicts.length > 0
          ? []
          : [
              [merged.file, theirs],
              [mine, merged.file],
            ]) {
          const again = mergeLevels(base, m, t);
          expect(again.conflicts).toEqual([]);
          expect(text(again.file)).toBe(text(merged.file));
        }

        const [b, m, t, result] = [base, mine, theirs, merged.file].map(entriesOf);
        const undecided = new Set(
          merged.conflicts.map(({ key }) => key.split('/')[1]?.replaceAll('~1', '/').replaceAll('~0', '~')),
        );
        for (const name of new Set([...m.keys(), ...t.keys()])) {
          const [old, here, there] = [b.get(name), m.get(name), t.get(name)];
          const isDeletedFreely = old !== undefined && (isSame(old, here ?? there) || isSame(old, there ?? here));
          if ((here !== undefined && there !== undefined) || !isDeletedFreely)
            expect(result.has(name) || undecided.has(name.replace(/^run /, '')), name).toBe(true);
        }
        for (const name of result.keys()) expect(m.has(name) || t.has(name)).toBe(true);
      }),
      { numRuns },
    );
  });

  it('are what both edits give one after the other, where they are apart', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryEdits(14), arbitraryEdits(14), (base, ours, others) => {
        // edits that refer to places in lists: each is applied to its own side, to know what it is about
        const both = structuredClone(base);
        const [mine, theirs] = [structuredClone(base), structuredClone(base)];
        const touched = new Map<string, number>();
        const turns = [...ours.map((edit) => ({ edit, side: 0 })), ...others.map((edit) => ({ edit, side: 1 }))];
        for (const { edit, side } of turns) {
          const about = apply(structuredClone(both), edit);
          const [owner] = about.split(' ');
          const other = 1 - side;
          const isObject = entriesOf(both).has(owner) || /^..$|^order$/.test(owner);
          const name = isObject ? owner : about.split(' ').slice(0, 2).join(' ');
          if (about === '' || about.startsWith('order ') || touched.get(name) === other || touched.get(about) === other) continue;
          const target = side === 0 ? mine : theirs;
          // the same edit must do the same in both files
          const [trialBoth, trialOwn] = [structuredClone(both), structuredClone(target)];
          if (apply(trialBoth, edit) !== apply(trialOwn, edit)) continue;
          const id = owner;
          if (isObject && !isSame(entriesOf(both).get(id), entriesOf(target).get(id))) continue;
          touched.set(name, side);
          touched.set(about, side);
          apply(both, edit);
          apply(target, edit);
        }
        const { file, conflicts } = mergeLevels(base, withIds(mine), withIds(theirs));
        expect(conflicts).toEqual([]);
        expect(content(file)).toEqual(content(withIds(both)));
      }),
      { numRuns },
    );
  });

  it('leave conflicts in the file that can be decided there as well as in the merge', () => {
    fc.assert(
      fc.property(arbitraryFork, fc.array(fc.boolean(), { minLength: 30, maxLength: 30 }), ({ base, mine, theirs }, coins) => {
        const merged = mergeLevels(base, mine, theirs);
        const choices = new Map(merged.conflicts.map(({ key }, i): [string, Side] => [key, coins[i % 30] ? 'theirs' : 'mine']));
        const later = resolveConflicts(withConflicts(merged), choices);
        expect(later.conflicts).toBeUndefined();
        expect(content(later)).toEqual(content(mergeLevels(base, mine, theirs, choices).file));
        expect(readLevel(text(later)).ok).toBe(true);
      }),
      { numRuns },
    );
  });

  it('are the same for files that lack ids, where only properties have changed', () => {
    const anonymous = (file: LevelFile): LevelFile => {
      const copy = structuredClone(file);
      for (const list of OBJECT_LISTS) for (const object of copy[list] ?? []) delete object.id;
      return copy;
    };
    const contents = (file: LevelFile) => OBJECT_LISTS.map((list) => anonymous(file)[list] ?? []);
    const fields = (most: number) => arbitraryEdits(most).map((edits) => edits.filter(({ what }) => what < 4));
    fc.assert(
      fc.property(arbitraryFile, fields(9), fields(9), fc.nat(7), (base, ours, others, who) => {
        const files = [base, edited(base, ours), edited(base, others)];
        const [b, m, t] = files.map((file, i) => ((who >> i) & 1 ? file : anonymous(file)));
        // equal objects can't be told apart
        const all = contents(base).flatMap((list) => list.map((object) => JSON.stringify(object)));
        fc.pre(new Set(all).size === all.length);
        const shared = shareIds(b, m, t);
        const one = mergeLevels(shared.base, shared.mine, shared.theirs);
        const two = mergeLevels(files[0], files[1], files[2]);
        expect(contents(one.file)).toEqual(contents(two.file));
        expect(one.conflicts.length).toBe(two.conflicts.length);
      }),
      { numRuns },
    );
  });
});
