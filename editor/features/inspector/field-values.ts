import type { LevelFile, ObjectKind } from '../../../schema/index.ts';
import type { FoundObject } from '../../core/document/index.ts';
import { type Field, fieldsOf } from './fields.ts';

/** What a field shows. */
export interface FieldValue {
  /** null if the selected objects differ */
  readonly value: number | string | boolean | null;
  /** The file has no value, so the default applies. */
  readonly isDefault: boolean;
}

type Json = Readonly<Record<string, unknown>>;

/** The value that objects have in common, with defaults filled in. */
export function valueOfObjects(objects: readonly FoundObject[], { key }: Field): FieldValue {
  const defaultOf = (kind: ObjectKind) => fieldsOf(kind).fields.find((field) => field.key === key)?.fallback;
  const shownOf = ({ kind, object }: FoundObject) => (object as unknown as Json)[key] ?? defaultOf(kind);
  const first = shownOf(objects[0]);
  return {
    value: objects.every((found) => shownOf(found) === first) ? ((first as FieldValue['value'] | undefined) ?? null) : null,
    isDefault: objects.every(({ object }) => (object as unknown as Json)[key] === undefined),
  };
}

/** The value of a field of the level itself. */
export function valueOfLevel(file: LevelFile, { key, fallback }: Field): FieldValue {
  const written = (file as Json)[key];
  return { value: ((written ?? fallback) as FieldValue['value'] | undefined) ?? null, isDefault: written === undefined };
}
