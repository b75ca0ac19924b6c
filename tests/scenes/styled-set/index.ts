export { hashStyledSet, STYLED_SET_HASH } from './frozen.ts';
export { STYLED_SET_SIZE, STYLES, styledLevel, styleOf } from './styled-level.ts';
