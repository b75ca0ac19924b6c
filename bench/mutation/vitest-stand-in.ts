// What test files get for 'vitest': the real assertions, and tests that a session can run repeatedly in one process.

export { expect, vi } from 'vitest';
export { afterAll, afterEach, beforeAll, beforeEach, describe, it, it as test } from './test-tree.ts';
