export { declare } from '../fmt.ts';
