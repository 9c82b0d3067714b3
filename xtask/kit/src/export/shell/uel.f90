! UEL, a user element of Abaqus/Standard: {title} with Lagrange multipliers.
!
! nodes    1 is a, 2 is b, each with translations 1-3 and rotations 4-6; 3 is an internal node, whose degrees of freedom
!          1-{multipliers} are the multipliers
! input    *USER ELEMENT, TYPE=U1, NODES=3, COORDINATES=3, PROPERTIES={properties}, VARIABLES={states}, UNSYMM
!          1, 2, 3, 4, 5, 6
!          3, {degrees}
! COORDS   the places of a and b at the start; that of the internal node has no part
! U        rotations are rotation vectors of the whole rotation, from which the triads follow; a step adds a spin in front of
!          them, as Abaqus does
! RHS      what the element exerts on its nodes, and by how much its conditions are off
! AMATRX   -dRHS/dU, with the spins of the nodes for their rotations; unsymmetric
! PNEWDT   0.5, and no contribution, where the element is not defined: the increment is tried again with half of the time
{places}!
! Put together from formulas that jointproof proves; free of conditions (CC0-1.0). Compile with -ffp-contract=off.
subroutine uel(rhs, amatrx, svars, energy, ndofel, nrhs, nsvars, props, nprops, coords, mcrd, nnode, u, du, v, a, &
        jtype, time, dtime, kstep, kinc, jelem, params, ndload, jdltyp, adlmag, predef, npredf, lflags, mlvarx, &
        ddlmag, mdload, pnewdt, jprops, njprop, period)
    use jp_element, only: dp, turned
    use jp_connector, only: connect, multipliers, properties, states
    implicit none
    integer, intent(in) :: ndofel, nrhs, nsvars, nprops, mcrd, nnode, jtype, kstep, kinc, jelem, ndload, npredf, &
        mlvarx, mdload, njprop
    integer, intent(in) :: jdltyp(mdload, *), lflags(*), jprops(*)
    real(dp), intent(in) :: props(*), coords(mcrd, nnode), u(ndofel), du(mlvarx, *), v(ndofel), a(ndofel), time(2), &
        dtime, params(*), adlmag(mdload, *), predef(2, npredf, nnode), ddlmag(mdload, *), period
    real(dp), intent(inout) :: rhs(mlvarx, *), amatrx(ndofel, ndofel), svars(*), energy(8), pnewdt
    real(dp) :: residual(multipliers), rows(multipliers, 12), force(12), stiffness(12, 12), &
        by_multipliers(12, multipliers), after(states)
    integer, parameter :: all = 12 + multipliers
    integer :: code

    rhs(:all, 1) = 0
    amatrx(:all, :all) = 0
    ! Residual and stiffness, stiffness alone, residual alone; no mass and no damping.
    if (lflags(3) /= 1 .and. lflags(3) /= 2 .and. lflags(3) /= 5) return
    call connect(turned(u(4:6), props(1:9)), turned(u(10:12), props(10:18)), coords(:3, 1) + u(1:3), &
        coords(:3, 2) + u(7:9), u(13:all), props(19:properties), svars(:states), after, residual, rows, force, stiffness, &
        by_multipliers, code)
    if (code /= 0) then
        pnewdt = min(pnewdt, 0.5_dp)
        return
    end if
    if (lflags(3) /= 2) then
        rhs(:12, 1) = force
        rhs(13:all, 1) = residual
        svars(:states) = after
    end if
    if (lflags(3) == 5) return
    amatrx(:12, :12) = -stiffness
    amatrx(:12, 13:all) = -by_multipliers
    amatrx(13:all, :12) = -rows
end subroutine uel
