export { declare, help } from './diff.ts';
export { difftool } from './difftool.ts';
