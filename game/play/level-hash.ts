import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex, utf8ToBytes } from '@noble/hashes/utils.js';
import { DEFAULT_RULES, fieldsOf, type Level, OBJECT_KINDS, objectsIn, RULE_NAMES, rulesOf } from '../../schema/basics/index.ts';

type Values = Readonly<Record<string, number | boolean>>;

/** Collects what is hashed. */
class Content {
  private readonly hash = sha256.create();

  /** A text cannot be taken for another, nor for numbers, as its length comes first. */
  text(text: string): void {
    const bytes = utf8ToBytes(text);
    this.numbers([bytes.length]);
    this.hash.update(bytes);
  }

  numbers(values: readonly (number | boolean)[]): void {
    const view = new DataView(new ArrayBuffer(8 * values.length));
    // + 0 turns -0 into 0
    for (const [i, value] of values.entries()) view.setFloat64(8 * i, Number(value) + 0, true);
    this.hash.update(new Uint8Array(view.buffer));
  }

  digest(): string {
    return bytesToHex(this.hash.digest());
  }
}

/**
 * The hash of everything of a level that matters for a play: the numbers and flags of its objects in their order, range, recoil
 * and rules. Names, descriptions, ids, runs and allowed problems don't count. Values that are left out in the file count as
 * their defaults, so that a kind of object, a field or a rule that a later version adds leaves the hashes of levels without it.
 *
 * @param level - the level
 * @returns its SHA-256, 64 hexadecimal digits
 *
 * @example
 * ```ts
 * const levels = new Map(all.map((level) => [levelHash(level), level]));
 * const decoded = decodePlay(bytes);
 * const level = decoded.ok ? levels.get(decoded.play.level) : undefined;
 * ```
 */
export function levelHash(level: Level): string {
  const content = new Content();
  content.text('gravity-quest level');
  for (const kind of OBJECT_KINDS) {
    const objects: readonly Values[] = objectsIn(level, kind);
    if (objects.length === 0) continue;
    content.text(kind);
    content.numbers([objects.length]);
    for (const [name, field] of fieldsOf(kind)) {
      const values = objects.map((object) => object[name]);
      if (values.every((value) => value === field.default)) continue;
      content.text(name);
      content.numbers(values);
    }
  }
  content.text('range');
  content.numbers([level.range]);
  content.text('recoil');
  content.numbers([level.recoil]);
  const rules = rulesOf(level);
  for (const name of RULE_NAMES) {
    if (rules[name] === DEFAULT_RULES[name]) continue;
    content.text(`rule ${name}`);
    content.numbers([rules[name]]);
  }
  return content.digest();
}
