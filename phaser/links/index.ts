export { type LinkedText, levelFragment, levelTextOf } from './level-link.ts';
