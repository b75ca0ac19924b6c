import type { LevelFile } from '../../../schema/index.ts';
import type { FoundObject } from '../../document/index.ts';
import { type Field, fieldsOf } from './fields.ts';

/** What a field shows. */
export interface FieldValue {
  /** null: the selected objects differ */
  readonly value: number | string | boolean | null;
  /** Nothing is written: the default stands for it. */
  readonly isDefault: boolean;
}

type Json = Readonly<Record<string, unknown>>;

function commonValue(all: readonly { readonly json: Json; readonly fallback: Field['fallback'] }[], key: string): FieldValue {
  const values = all.map(({ json, fallback }) => (json[key] ?? fallback) as number | string | boolean);
  return {
    value: values.every((value) => value === values[0]) ? (values[0] ?? null) : null,
    isDefault: all.every(({ json }) => json[key] === undefined),
  };
}

/** What a field of objects shows: what they have in common, defaults filled in. */
export function valueOfObjects(objects: readonly FoundObject[], { key }: Field): FieldValue {
  const all = objects.map(({ kind, object }) => ({
    json: object as unknown as Json,
    fallback: fieldsOf(kind).fields.find((field) => field.key === key)?.fallback,
  }));
  return commonValue(all, key);
}

/** What a field of the level itself shows. */
export const valueOfLevel = (file: LevelFile, { key, fallback }: Field): FieldValue =>
  commonValue([{ json: file, fallback }], key);
