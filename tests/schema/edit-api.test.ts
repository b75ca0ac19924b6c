import { STATUS_CODES } from 'node:http';
import { describe, expect, test } from 'vitest';
import {
  deleteRequestSchema,
  EDIT_ERRORS,
  errorResponseSchema,
  LEVEL_ID_PART,
  listResponseSchema,
  orderRequestSchema,
  restoreRequestSchema,
} from '../../schema/index.ts';

const client = 'page-1';

describe('the API of gq edit', () => {
  test('refuses with the matching HTTP status codes', () => {
    const byStatus: Record<string, string[]> = {};
    for (const [code, status] of Object.entries(EDIT_ERRORS).sort()) {
      byStatus[STATUS_CODES[status] ?? status] ??= [];
      byStatus[STATUS_CODES[status] ?? status].push(code);
    }
    expect(byStatus).toEqual({
      'Bad Request': ['bad-name', 'bad-request', 'upgrade-refused'],
      Unauthorized: ['wrong-token'],
      Forbidden: ['foreign-page', 'not-writable', 'wrong-host'],
      'Not Found': ['unknown-address', 'unknown-folder', 'unknown-level'],
      'Method Not Allowed': ['wrong-method'],
      Conflict: ['list-changed', 'name-taken', 'not-completable', 'not-published'],
      'Precondition Failed': ['conflict'],
      'Payload Too Large': ['body-too-large'],
      'Unsupported Media Type': ['wrong-content-type'],
      'Unprocessable Entity': ['invalid-level', 'invalid-pack'],
      'Precondition Required': ['base-missing'],
      'Internal Server Error': ['failed'],
      'Service Unavailable': ['busy'],
      'Insufficient Storage': ['disk-full'],
    });
  });

  test('accepts ids of 1 to 4096 characters, folders of 0 to 4096, and a name from the trash', () => {
    const takes = (id: string) => deleteRequestSchema.safeParse({ id, client }).success;
    expect(['', 'a', 'a'.repeat(4096), 'a'.repeat(4097)].map(takes)).toEqual([false, true, true, false]);
    const orders = (folder: string) => orderRequestSchema.safeParse({ folder, ids: [], client }).success;
    expect(['', 'a'.repeat(4096), 'a'.repeat(4097)].map(orders)).toEqual([true, true, false]);
    const ids = (length: number) => orderRequestSchema.safeParse({ folder: '', ids: Array(length).fill('a'), client }).success;
    expect([100_000, 100_001].map(ids)).toEqual([true, false]);
    const restores = (trash: string) => restoreRequestSchema.safeParse({ trash, client }).success;
    expect(['', 'a', 'a'.repeat(4200), 'a'.repeat(4201)].map(restores)).toEqual([false, true, true, false]);
  });

  test('names files of 1 to 80 characters', () => {
    const names = [
      '',
      'a',
      'ab',
      'a b',
      `a${'b'.repeat(79)}`,
      `a${'b'.repeat(80)}`,
      'a ',
      ' a',
      '-a',
      'a-',
      'a.b',
      'con',
      'COM1',
      'cone',
    ];
    expect(names.filter((name) => LEVEL_ID_PART.test(name))).toEqual(['a', 'ab', 'a b', `a${'b'.repeat(79)}`, 'a-', 'cone']);
  });

  test('accepts 0 unread levels, and places from line 1 and column 1 on', () => {
    const list = (unread: number) =>
      listResponseSchema.safeParse({
        ...{ folder: { id: '', path: '', $schema: null }, folders: [], levels: [], troubles: [], unread },
        terms: { file: null, accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {}, problems: [] },
      }).success;
    expect([-1, 0, 1, 1.5].map(list)).toEqual([false, true, true, false]);
    const problem = (line: number | null, column: number | null) =>
      errorResponseSchema.safeParse({
        error: {
          ...{ code: 'invalid-level', message: '', hint: '' },
          problems: [{ code: '', severity: 'error', message: '', hint: '', pointer: '', line, column }],
        },
      }).success;
    expect([problem(1, 1), problem(null, null), problem(0, 1), problem(1, 0)]).toEqual([true, true, false, false]);
  });
});
