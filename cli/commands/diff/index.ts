export { declare } from './diff.ts';
export { declareDifftool } from './difftool.ts';
