/**
 * What review of levels needs: merging versions of a level, and saying what differs between them. The command line and the
 * editor share this code.
 *
 * @module
 */

export * from './diff/index.ts';
export * from './merge/index.ts';
