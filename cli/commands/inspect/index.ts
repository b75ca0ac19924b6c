export { declare } from '../inspect.ts';
