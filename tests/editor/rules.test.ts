// Rules in the editor: clamping, setting, resetting, merging, display, sliders; and that the proof uses them.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createEditedLevel, resetRules, setRule } from '../../editor/core/document/index.ts';
import { NO_FOLDER_TERMS, withKeptTerms } from '../../editor/core/files/folder-list.ts';
import { createProofStore, createProver } from '../../editor/core/proof/index.ts';
import {
  originOf,
  positionOf,
  ruleLabel,
  ruleValues,
  SLIDER_END,
  stepOf,
  valueAt,
} from '../../editor/features/inspector/index.ts';
import { compile, DEFAULT_TERMS, simulate } from '../../engine/index.ts';
import { mergeLevels } from '../../review/index.ts';
import {
  type FolderTerms,
  formatLevel,
  type LevelFile,
  type ListResponse,
  type OwnRules,
  RULE_NAMES,
  RULES,
  readLevel,
  resolveLevel,
  rulesOf,
  rulesSchema,
} from '../../schema/index.ts';
import { SWING } from './swing-level.ts';

const name = fc.constantFrom(...RULE_NAMES);
const value = fc.oneof(fc.double({ noNaN: true }), fc.integer({ min: -2000, max: 20_000 }));

describe('rules of an open level', () => {
  it('are clamped to their limits, and leave a valid level', () => {
    fc.assert(
      fc.property(fc.array(fc.tuple(name, fc.option(value, { nil: undefined })), { maxLength: 6 }), (changes) => {
        const level = createEditedLevel(SWING);
        const expected: Record<string, number> = {};
        for (const [rule, to] of changes) {
          expect(level.change('Set', setRule(rule, to)).ok).toBe(true);
          if (to === undefined) delete expected[rule];
          else expected[rule] = Math.min(RULES[rule].most, Math.max(RULES[rule].least, to)) + 0;
        }
        expect(level.file().rules ?? {}).toEqual(expected);
        expect('rules' in level.file()).toBe(Object.keys(expected).length > 0);
        expect(readLevel(formatLevel(level.file())).ok).toBe(true);
        // everything is undone
        while (level.undo());
        expect(level.file()).toEqual(createEditedLevel(SWING).file());
      }),
    );
  });

  it('are refused if they are unknown or not numbers', () => {
    for (const rules of [{ pul: 3 }, { pull: '3' }, { pull: Number.NaN }, [], 7, null]) {
      const level = createEditedLevel(SWING);
      const result = level.change('Set', (draft) => void Object.assign(draft, { rules }));
      expect([rules, result.ok]).toEqual([rules, false]);
    }
  });

  it('can all be reset at once, which keeps the keys of other programs', () => {
    const level = createEditedLevel({ ...SWING, rules: { pull: 45, push: 3, 'x-why': 'a test' } } as LevelFile);
    level.change('Reset', resetRules);
    expect(level.file().rules).toEqual({ 'x-why': 'a test' });
    level.undo();
    expect(level.file().rules).toMatchObject({ pull: 45, push: 3 });
    const plain = createEditedLevel({ ...SWING, rules: { pull: 45 } });
    plain.change('Reset', resetRules);
    expect('rules' in plain.file()).toBe(false);
  });

  it('are merged one by one', () => {
    const base = { ...SWING, rules: { pull: 45 } };
    const mine = { ...SWING, rules: { pull: 45, push: 30 } };
    const theirs = { ...SWING, rules: { pull: 50 } };
    expect(mergeLevels(base, mine, theirs)).toEqual({ file: { ...SWING, rules: { pull: 50, push: 30 } }, conflicts: [] });
    const other = { ...SWING, rules: { pull: 55 } };
    expect(mergeLevels(base, theirs, other).conflicts).toMatchObject([{ key: 'rules/pull', base: 45, mine: 50, theirs: 55 }]);
    expect(mergeLevels(base, SWING, base).file).toEqual(SWING);
    expect(mergeLevels(SWING, SWING, { ...SWING, rules: {} }).file).toEqual({ ...SWING, rules: {} });
  });
});

describe('the proof', () => {
  const end = (file: LevelFile, folder: OwnRules = {}) => {
    const run = simulate(compile(resolveLevel(file, folder), 'precise'), [[150, 435]]);
    return { outcome: run.outcome, time: run.time };
  };
  const shown = (proof: ReturnType<typeof createProofStore>) => {
    const { outcome, time } = proof.proof().run;
    return { outcome, time };
  };

  it('follows a rule while it is dragged, and when that is cancelled', () => {
    const level = createEditedLevel(SWING);
    const proof = createProofStore(level, DEFAULT_TERMS);
    expect(proof.proof().verdict).toBe('completable');
    const gesture = level.begin('Set pull');
    for (const pull of [40, 43, 46]) {
      gesture.set(setRule('pull', pull));
      expect(shown(proof)).toEqual(end({ ...SWING, rules: { pull } }));
    }
    expect(proof.proof().verdict).toBe('broken');
    expect(level.committedFile().rules).toBeUndefined();
    gesture.commit();
    expect([level.labels(), level.file().rules]).toEqual([['Set pull'], { pull: 46 }]);
    level.undo();
    expect([proof.proof().verdict, shown(proof)]).toEqual(['completable', end(SWING)]);
    proof.close();
  });

  it("uses the folder's rules if the level has none, and follows their changes", () => {
    const level = createEditedLevel(SWING);
    const proof = createProofStore(level, { ...DEFAULT_TERMS, rules: { pull: 45 } });
    expect([proof.proof().verdict, shown(proof)]).toEqual(['broken', end(SWING, { pull: 45 })]);
    level.change('Set', setRule('pull', 39));
    expect([proof.proof().verdict, proof.proof().scene.rules.pull]).toEqual(['completable', 39]);
    level.undo();
    expect(proof.proof().verdict).toBe('broken');
    proof.setTerms({ ...DEFAULT_TERMS, rules: { boxWidth: 40 } });
    expect(proof.proof().verdict).toBe('completable');
    expect(proof.proof().scene.box.halfWidth).toBe(20);
    proof.close();
  });

  it('keeps its level if neither the file nor the terms change, and its scene if the motion stays the same', () => {
    const prover = createProver(() => 0);
    const rules = { pull: 45 };
    const terms = { ...DEFAULT_TERMS, rules };
    const question = { file: SWING, run: null, terms } as const;
    const first = prover.prove(question);
    expect(prover.prove(question)).toBe(first);
    expect(prover.prove({ ...question, run: 'other' }).level).toBe(first.level);
    // the same numbers from another source give the same scene
    expect(prover.prove({ ...question, file: { ...SWING, rules } }).scene).toBe(first.scene);
    expect(prover.prove({ ...question, terms: { ...terms, rules: { pull: 46 } } }).scene.rules.pull).toBe(46);
  });
});

describe('the terms of a list', () => {
  const list = (terms: FolderTerms): ListResponse => ({
    ...{ folder: { id: 'f', path: 'levels', $schema: null }, folders: [''], levels: [], troubles: [], unread: 0 },
    terms,
  });

  it('are the same objects as before if they are equal, so that subscribers see no change', () => {
    const before = list({ ...NO_FOLDER_TERMS, file: 'gq.config.json', rules: { pull: 45 } });
    const again = structuredClone(before);
    expect(withKeptTerms(again, before).terms).toBe(before.terms);
    expect(withKeptTerms(again, null)).toBe(again);
    const problem = { code: 'a', severity: 'error', message: '', hint: '', pointer: '', line: 1, column: 1 } as const;
    const wrong = withKeptTerms(list({ ...again.terms, problems: [problem] }), before);
    expect(wrong.terms.problems).toEqual([problem]);
    expect(wrong.terms.rules).toBe(before.terms.rules);
    expect(withKeptTerms(list({ ...again.terms, rules: { pull: 46 } }), before).terms.rules).toEqual({ pull: 46 });
  });
});

describe('a rule in the inspector', () => {
  const FOLDER = { ...NO_FOLDER_TERMS, file: 'gq.config.json', rules: { pull: 45 } };
  const NONE = NO_FOLDER_TERMS;
  const pullOf = (rules: OwnRules | undefined, folder: FolderTerms) => {
    const pull = ruleValues({ rules }, folder).find((rule) => rule.name === 'pull');
    if (pull === undefined) throw new Error('there is no pull');
    const { value, isOwn, fallback, from } = pull;
    return { value, isOwn, fallback, from, says: originOf(pull) };
  };

  it('shows its value, the value without the level, and the source of that', () => {
    expect(pullOf(undefined, NONE)).toEqual({ value: 39, isOwn: false, fallback: 39, from: null, says: null });
    const says = "Set by this level; the game's default is 39.";
    expect(pullOf({ pull: 30 }, NONE)).toEqual({ value: 30, isOwn: true, fallback: 39, from: null, says });
    const from = 'gq.config.json';
    const ofFolder = { fallback: 45, from };
    expect(pullOf(undefined, FOLDER)).toEqual({
      ...{ value: 45, isOwn: false, ...ofFolder },
      says: "From gq.config.json; the game's default is 39.",
    });
    expect(pullOf({ pull: 39 }, FOLDER)).toEqual({
      ...{ value: 39, isOwn: true, ...ofFolder },
      says: 'Set by this level; gq.config.json has 45.',
    });
  });

  it('shows the value that the simulation uses', () => {
    const rules = fc.record(
      Object.fromEntries(RULE_NAMES.map((rule) => [rule, fc.constantFrom(RULES[rule].most, RULES[rule].default, undefined)])),
    ) as fc.Arbitrary<OwnRules>;
    fc.assert(
      fc.property(rules, rules, (own, folder) => {
        const values = ruleValues({ rules: own }, { ...NO_FOLDER_TERMS, file: 'gq.config.json', rules: folder });
        const played = rulesOf(resolveLevel({ ...SWING, rules: own }, folder));
        expect(Object.fromEntries(values.map((rule) => [rule.name, rule.value]))).toEqual(played);
      }),
    );
  });

  it('has a unique name', () => {
    expect(RULE_NAMES.map(ruleLabel)).toContain('speed limit');
    // the level already has a switch of that name
    expect(ruleLabel('recoil')).toBe('recoil strength');
    expect(new Set(RULE_NAMES.map(ruleLabel)).size).toBe(RULE_NAMES.length);
  });
});

describe.each(RULE_NAMES)('the slider of %s', (rule) => {
  const { least, most, default: usual } = RULES[rule];

  it('has exactly the values of the rule, in order, and is at the place of its value', () => {
    expect([valueAt(RULES[rule], 0), valueAt(RULES[rule], SLIDER_END)]).toEqual([least, most]);
    fc.assert(
      fc.property(
        fc.double({ min: 0, max: SLIDER_END, noNaN: true }),
        fc.double({ min: 0, max: SLIDER_END, noNaN: true }),
        (a, b) => {
          const [one, other] = [valueAt(RULES[rule], Math.min(a, b)), valueAt(RULES[rule], Math.max(a, b))];
          expect(one).toBeLessThanOrEqual(other);
          expect(rulesSchema.safeParse({ [rule]: one }).success).toBe(true);
          // neighbours may round to the same value
          expect(valueAt(RULES[rule], positionOf(RULES[rule], one))).toBe(one);
        },
      ),
    );
    fc.assert(
      fc.property(fc.double({ min: least, max: most, noNaN: true }), (exact) => {
        const position = positionOf(RULES[rule], exact);
        expect(position).toBeGreaterThanOrEqual(0);
        expect(position).toBeLessThanOrEqual(SLIDER_END);
        expect(Math.abs(valueAt(RULES[rule], position) - exact)).toBeLessThanOrEqual(Math.max(stepOf(RULES[rule]), exact / 100));
      }),
    );
  });

  it("has room around the game's default, which can be set exactly, and small steps", () => {
    const at = positionOf(RULES[rule], usual);
    expect(at).toBeGreaterThan(SLIDER_END / 4);
    expect(valueAt(RULES[rule], at)).toBe(usual);
    expect(stepOf(RULES[rule])).toBeLessThanOrEqual(usual / 20);
    expect(stepOf(RULES[rule])).toBeGreaterThan(usual / 250);
  });
});
