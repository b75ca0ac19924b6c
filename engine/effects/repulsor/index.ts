export { letGoTime } from './let-go.ts';
export { repulsor } from './repulsor.ts';
