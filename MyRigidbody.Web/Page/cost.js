export function startCost() {
}
