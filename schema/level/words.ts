import {
  ALLOWABLE_CODES,
  DEFAULT_RANGE,
  fieldsOf,
  KINDS,
  LISTED_KINDS,
  OBJECT_KINDS,
  type ObjectKind,
  RULE_NAMES,
} from '../basics/index.ts';
import { RULES } from './rules.ts';

/** What the values of a shape mean, by their path; every entry of a list is `*`. */
export type Words = Readonly<Record<string, string>>;

/** What the keys of an object of a kind mean, by their path in the object; of the object itself under ''. */
const wordsOfKind = (kind: ObjectKind): Words => ({
  '': KINDS[kind].about,
  id: 'Short random name of this object: it stays while the object is moved and edited. Unique in the level; `gq fmt` adds missing ones.',
  ...Object.fromEntries(fieldsOf(kind).map(([name, { about }]) => [name, about])),
});

const RULE_WORDS: Words = {
  '': 'Numbers of the game that are another here; the game’s own when left out.',
  ...Object.fromEntries(
    RULE_NAMES.map((name) => [name, `${RULES[name].about} In ${RULES[name].unit}; ${RULES[name].default} when left out.`]),
  ),
};

/** The words of a part of a level, by their path in the level. */
const below = (path: string, words: Words): Words =>
  Object.fromEntries(Object.entries(words).map(([key, about]) => [key === '' ? path : `${path}/${key}`, about]));

/** What the values in a level file mean. */
export const LEVEL_WORDS: Words = {
  '': 'A level of Gravity Quest. Keys that begin with x- are yours: they are kept and not checked.',
  $schema: 'Where the JSON Schema of this format is, for editors.',
  version: 'Version of this format.',
  ...below('conflicts', {
    '': 'What a merge left undecided: `gq check` refuses the level until the list is gone.',
    '*': 'A property that two merged versions changed in different ways.',
    '*/what': 'What it is about, in words.',
    '*/key': 'The property it is about, such as asteroids/k3x9qa/radius.',
    '*/base': 'The value before both changes; left out when there was none.',
    '*/ours': 'The value of our version, which stands in the level; left out when it is deleted there.',
    '*/theirs': 'The value of their version; left out when it is deleted there.',
  }),
  name: 'What players and reports call the level.',
  description: 'What the level teaches or asks for.',
  range: `Farther than this from the centre of every asteroid she is lost, px; ${DEFAULT_RANGE} when left out.`,
  recoil: 'Whether the target of the gun is pulled towards her, too; false when left out.',
  ...below('rules', RULE_WORDS),
  ...below('allow', {
    '': 'Problems that are meant in this level, each with the reason: `gq check` does not report them.',
    ...Object.fromEntries(ALLOWABLE_CODES.map((code) => [code, `Why ${code} is meant in this level.`])),
  }),
  ...Object.assign(
    {},
    ...OBJECT_KINDS.map((kind) => below(KINDS[kind].list === null ? kind : `${KINDS[kind].list}/*`, wordsOfKind(kind))),
  ),
  ...Object.fromEntries(LISTED_KINDS.map((kind) => [KINDS[kind].list, KINDS[kind].aboutList])),
  ...below('runs', {
    '': 'Scripted runs; the first is the one that is shown.',
    '*': 'What a player does: proof that the level can be completed, or that it fails as it should.',
    '*/name': 'Unique in the level.',
    '*/holds': 'When the gun is held.',
    '*/holds/*': '[press, release): ticks of 1/60 s; the gun is held from press up to, not including, release.',
    '*/notes': 'Notes at ticks; `gq fmt` sorts them by tick.',
    '*/notes/*': 'What somebody wrote at a tick of a run. It changes nothing in play.',
    '*/notes/*/tick': 'The tick that it is about.',
    '*/notes/*/text': 'What it says, on one line, without white space at its ends.',
  }),
};
