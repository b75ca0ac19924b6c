import { effectInWords, introductionsOf, jumpsOf, type MetLevel, packProblems, shownEntries } from '../../../check/pack/index.ts';
import { type LevelEntry, levelOfEntry, type PackFile, type Problem } from '../../../schema/index.ts';
import type { FolderPack } from '../../core/files/index.ts';
import type { LevelFacts } from '../../workers/index.ts';

/** The grade of a level, as far as it is known. */
export interface ShownGrade {
  /** 1 to 10; null: none of its runs completes the level. */
  readonly value: number | null;
  readonly word: string;
  /** Whether the level has changed since. */
  readonly isOld: boolean;
}

/** A level as a card. */
export interface Card {
  readonly key: string;
  /** Its place among all entries, also headings, from 0. */
  readonly place: number;
  /** Its number among the levels, from 1. */
  readonly number: number;
  readonly id: string;
  /** null: there is no such level. */
  readonly entry: LevelEntry | null;
  /** Whether the pack lists it; without a pack every level is. */
  readonly isListed: boolean;
  /** undefined until they are known; null for a file that is no valid level. */
  readonly facts: LevelFacts | null | undefined;
  readonly grade: ShownGrade | null;
  /** The effects that players meet here for the first time, in words. */
  readonly introduces: readonly string[];
  /** By how much it is harder than all before it, if it is much harder; else null. */
  readonly jump: number | null;
}

/** Levels below one heading. */
export interface Chapter {
  readonly key: string;
  /** The place of the heading among all entries; null: the levels stand below none. */
  readonly place: number | null;
  /** null: below no heading. */
  readonly name: string | null;
  /** Whether these are the levels that the pack does not list. */
  readonly isUnlisted: boolean;
  readonly cards: readonly Card[];
}

/** All that the view shows. */
export interface PackModel {
  readonly name: string | null;
  readonly chapters: readonly Chapter[];
  /** In the order in which they are played. */
  readonly cards: readonly Card[];
  readonly problems: readonly Problem[];
  /** How many levels are not looked at yet. */
  readonly unread: number;
}

/** What the view is made of. */
interface PackParts {
  /** In the order in which they are shown. */
  readonly levels: readonly LevelEntry[];
  readonly pack: FolderPack;
  readonly factsOf: (entry: LevelEntry) => LevelFacts | null | undefined;
  readonly gradeOf: (entry: LevelEntry) => ShownGrade | null;
}

/** The view of a folder: its entries in order, with what is known of each. */
export function modelOf({ levels, pack, factsOf, gradeOf }: PackParts): PackModel {
  const ids = levels.map(({ id }) => id);
  const file: PackFile | null = pack.kind === 'valid' ? pack.reading.pack : null;
  const shown = file === null ? ids.map((entry) => ({ entry, isListed: true })) : shownEntries(file, ids);
  const byId = new Map(levels.map((entry) => [entry.id, entry]));
  const met = levels.map((entry): MetLevel => ({ id: entry.id, effects: factsOf(entry)?.effects ?? null }));
  const cards = cardsOf(shown, byId, { factsOf, gradeOf });
  const introduced = introductionsOf(inPlay(cards, met));
  const jumps = new Map(
    jumpsOf(cards.map(({ isListed, grade }) => (isListed ? (grade?.value ?? null) : null))).map((jump) => [jump.index, jump.by]),
  );
  const whole = cards.map((card, i): Card => {
    const introduces = card.isListed && isFirst(cards, i) ? (introduced.get(card.id) ?? []).map(effectInWords) : [];
    return { ...card, introduces, jump: jumps.get(i) ?? null };
  });
  const problems = pack.kind === 'valid' ? packProblems(pack.reading, met) : pack.kind === 'invalid' ? pack.reading.problems : [];
  const unread = levels.filter((entry) => factsOf(entry) === undefined).length;
  return { name: file?.name ?? null, chapters: chaptersOf(shown, whole), cards: whole, problems, unread };
}

type Shown = readonly { readonly entry: PackFile['levels'][number]; readonly isListed: boolean }[];

function cardsOf(
  shown: Shown,
  byId: ReadonlyMap<string, LevelEntry>,
  { factsOf, gradeOf }: Pick<PackParts, 'factsOf' | 'gradeOf'>,
): Card[] {
  const cards: Card[] = [];
  const keys = new Set<string>();
  for (const [place, { entry: one, isListed }] of shown.entries()) {
    const id = levelOfEntry(one);
    if (id === null) continue;
    const entry = byId.get(id) ?? null;
    // a level that is listed twice has two cards
    const key = keys.has(id) ? `${id} ${place}` : id;
    keys.add(key);
    const known = { facts: entry === null ? null : factsOf(entry), grade: entry === null ? null : gradeOf(entry) };
    cards.push({ key, place, number: cards.length + 1, id, entry, isListed, ...known, introduces: [], jump: null });
  }
  return cards;
}

/** The levels as players meet them: those that are there and listed, each once. */
function inPlay(cards: readonly Card[], met: readonly MetLevel[]): MetLevel[] {
  const byId = new Map(met.map((level) => [level.id, level]));
  return cards.flatMap((card, i) => (card.isListed && isFirst(cards, i) ? (byId.get(card.id) ?? []) : []));
}

const isFirst = (cards: readonly Card[], index: number): boolean => cards[index].key === cards[index].id;

function chaptersOf(shown: Shown, cards: readonly Card[]): Chapter[] {
  const byPlace = new Map(cards.map((card) => [card.place, card]));
  const chapters: { key: string; place: number | null; name: string | null; isUnlisted: boolean; cards: Card[] }[] = [];
  for (const [place, { entry, isListed }] of shown.entries()) {
    if (typeof entry === 'object' && 'chapter' in entry) {
      chapters.push({ key: `chapter ${place}`, place, name: entry.chapter, isUnlisted: false, cards: [] });
      continue;
    }
    const last = chapters.at(-1);
    const card = byPlace.get(place);
    if (card === undefined) continue;
    if (last === undefined || last.isUnlisted === isListed)
      chapters.push({ key: isListed ? 'first' : 'unlisted', place: null, name: null, isUnlisted: !isListed, cards: [card] });
    else last.cards.push(card);
  }
  return chapters;
}

/** Which cards are shown. */
export interface Filter {
  /** Words that must all occur in the name or the file name. */
  readonly text: string;
  /** The verdict; '' for any. */
  readonly verdict: string;
  /** The effect that the level calls for; '' for any. */
  readonly effect: string;
}

export const NO_FILTER: Filter = { text: '', verdict: '', effect: '' };

export const isFiltered = ({ text, verdict, effect }: Filter): boolean => text.trim() !== '' || verdict !== '' || effect !== '';

/** Whether a card passes. @param verdict that of the card */
export function passes(card: Card, verdict: string, filter: Filter): boolean {
  const name = `${card.entry?.name ?? ''} ${card.id}`.toLowerCase();
  const words = filter.text.toLowerCase().split(/\s+/).filter(Boolean);
  if (!words.every((word) => name.includes(word))) return false;
  if (filter.verdict !== '' && verdict !== filter.verdict) return false;
  return filter.effect === '' || card.facts?.effects.includes(filter.effect) === true;
}

/** The effects that some card has, for a choice: value and words. */
export function effectsOf(cards: readonly Card[]): readonly (readonly [value: string, words: string])[] {
  const names = new Set(cards.flatMap(({ facts }) => facts?.effects ?? []));
  return [...names].sort().map((name) => [name, effectInWords(name)] as const);
}
